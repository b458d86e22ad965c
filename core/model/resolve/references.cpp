// Checks references by name: existence and kind of the target, with suggestions.

#include <algorithm>

#include "base/spelling.h"
#include "model/config_blocks.h"
#include "model/dotted_path.h"
#include "model/name_walk.h"
#include "model/resolve/resolve_steps.h"
#include "schema/value_words.h"

namespace trundle {

namespace {

constexpr int kMaxFollowUps = 3; ///< number of reports of one unknown name

bool kindFits(const Part& part, const std::vector<std::string>& choices) {
    if (choices.empty() || !part.kind) return true; // an unknown kind was reported already
    return std::any_of(choices.begin(), choices.end(),
                       [&](const std::string& c) { return c == part.kind->name || c == roleName(part.kind->role); });
}

bool wantsGeom(const Registry& registry, const std::vector<std::string>& choices) {
    return std::any_of(choices.begin(), choices.end(), [&](const std::string& c) {
        const Kind* kind = registry.find(c);
        return c == "Geom" || (kind && kind->role == Role::Geom);
    });
}

/// Whether `world` can be named. In scenery, and so in a PartConfig that is checked by itself, it is also the body that devices are fixed to.
bool takesWorld(const Property& property, const PartFrame& frame) {
    const auto has = [&](const char* choice) { return std::count(property.choices.begin(), property.choices.end(), choice) > 0; };
    const PartFrame* root = &frame;
    while (root->outer) root = root->outer;
    const bool canBeScenery = root->isOpen || (root->config && root->config->kind->name == "StaticConfig");
    return has("world") || (has("Body") && property.name != "Child" && canBeScenery);
}

/// All names that the property accepts, in text order; at most a few hundred, since Parts may hold very many.
class FittingNames {
public:
    FittingNames(const Property& property, bool geoms) : m_property(property), m_geoms(geoms) {}

    std::vector<std::string> in(const PartFrame& frame) {
        for (const PartFrame* at = &frame; at && at->config; at = at->member ? at->outer : nullptr) add(*at->config);
        if (takesWorld(m_property, frame)) m_names.push_back("world");
        return std::move(m_names);
    }

private:
    void add(const Part& config) {
        constexpr std::size_t kMost = 500, kMostBlocks = 10'000;
        NameWalk(kMostBlocks).inside(config, {}, [&](const Part& part, const std::string& prefix) {
            if (m_names.size() > kMost) return false;
            const bool fits = part.kind && !part.isRepeat() && !part.name.empty() && kindFits(part, m_property.choices);
            if (fits) m_names.push_back(prefix + part.name);
            return m_geoms || !part.is(Role::Body);
        });
    }

    const Property& m_property;
    bool m_geoms;
    std::vector<std::string> m_names;
};

/// Where a value is written that a Param has brought in; not known for others.
SourceRange sourceOf(const Record& record, std::string_view property) {
    for (const auto& [index, value] : record.names)
        if (record.kind->properties[index].name == property && value.elements.size() == 1) return value.elements[0].source;
    return {};
}

/// How far from a block's own text a value comes: what is nearest to it was right before the other one was given.
int distanceOf(const ResolveContext& context, const Record& record, const Part& part, const char* property) {
    const ResolvedValue* value = record.find(property);
    if (!value) return 0;
    if (value->origin == Origin::Instance || value->origin == Origin::CommandLine) return 4;
    if (record.givenOutside(property).known()) return 3;
    if (value->origin != Origin::Param) return 0;
    const SourceRange source = sourceOf(record, property);
    const auto holds = [](const Part& config, const SourceRange& range) {
        return config.range.file == range.file && config.range.range.begin <= range.range.begin &&
               config.range.range.end >= range.range.end;
    };
    const bool isDefault = std::ranges::any_of(
        context.outline.configs.all(), [&](const Part* config) { return holds(*config, part.range) && holds(*config, source); });
    return source.known() && !isDefault ? 2 : 1;
}

/// The frame that a name is looked up in: a word that a Param brought in from outside belongs there, and the default of a Param may
/// name something of the part or of what uses it.
const PartFrame& frameOf(const PartFrame& frame, const std::string& name, const GivenElement* given) {
    const PartFrame* at = &frame;
    for (std::uint32_t level = given ? given->level : 0; level > 0 && at->holder().outer; --level) at = at->holder().outer;
    if (given && given->literal) { // of an override: it may also name what is further in, in the Part that it sets a value of
        if (at->frameOf(name).find(name)) return at->frameOf(name);
        for (const PartFrame* inner = &frame; inner && inner != at; inner = inner->outer)
            if (inner->find(name)) return *inner;
    }
    if (!given || given->level > 0 || given->literal) return at->frameOf(name);
    const PartFrame* outermost = at;
    for (const PartFrame* outer = at; outer; outer = outer->outer) {
        if (outer->find(name)) return *outer;
        outermost = outer;
    }
    return *outermost;
}

bool endsInside(std::string_view path, std::string_view end) {
    return path.size() > end.size() && path.ends_with(end) && path[path.size() - end.size() - 1] == '.';
}

/// For a text such as "left, right" that is read as one name: its names, if all are known; else empty.
std::string listOf(std::string_view text, const std::vector<std::string>& names) {
    std::string list;
    std::size_t count = 0;
    for (std::size_t at = text.find_first_not_of(" ,;"); at != std::string_view::npos; ++count) {
        const std::size_t end = std::min(text.find_first_of(" ,;", at), text.size());
        const std::string name(text.substr(at, end - at));
        if (std::ranges::find(names, name) == names.end()) return {};
        list += (list.empty() ? "" : ",") + name;
        at = text.find_first_not_of(" ,;", end);
    }
    return count > 1 ? list : std::string();
}

/// The candidates in the same Part as a name.
std::vector<std::string> besideIt(std::string_view name, const std::vector<std::string>& candidates) {
    std::vector<std::string> beside;
    const std::string_view before = withoutLastWord(name);
    for (const std::string& candidate : candidates)
        if (!before.empty() && withoutLastWord(candidate) == before) beside.push_back(candidate);
    return beside;
}

/// The candidates that an unknown name may mean. Of those in the same Part, if there are any, only one whose own name is spelt alike.
std::vector<std::string> meant(std::string_view name, const std::vector<std::string>& candidates, bool hasBeside) {
    if (std::string list = listOf(name, candidates); !list.empty()) return {std::move(list)};
    std::vector<std::string> near;
    for (const std::string& candidate : candidates) { // `chassis.bumper` is suggested for `bumper`, `cart.b` for `lane.cart.b`
        if (endsInside(candidate, name) || endsInside(name, candidate)) near.push_back(candidate);
    }
    for (std::string& word : nearestWords(name, candidates)) {
        const std::string last(lastWord(word));
        const bool isBeside = hasBeside && withoutLastWord(word) == withoutLastWord(name);
        if (isBeside && nearestWords(lastWord(name), std::span(&last, 1)).empty()) continue;
        if (!std::count(near.begin(), near.end(), word)) near.push_back(std::move(word));
    }
    return near;
}

/// First what is inside: `chassis.bumper` for `chassis`.
std::vector<std::string> insideFirst(const std::string& name, const std::vector<std::string>& candidates) {
    std::vector<std::string> near;
    for (const std::string& candidate : candidates)
        if (candidate.starts_with(name + ".")) near.push_back(candidate);
    for (const std::string& word : nearestWords(name, candidates))
        if (!std::count(near.begin(), near.end(), word)) near.push_back(word);
    return near;
}

} // namespace

std::string otherEnd(const Record& record, std::string_view property) {
    const ResolvedValue* other = property == "Child"    ? record.find("Parent")
                                 : property == "Parent" ? record.find("Child")
                                                        : nullptr;
    return other && other->value.texts.size() == 1 ? other->value.texts[0] : std::string();
}

void ResolveContext::NotMeant::eraseFrom(std::vector<std::string>& names) const {
    std::erase_if(names,
                  [this](const std::string& name) { return name == otherEnd || (part && name.starts_with(part->name + ".")); });
}

void ResolveContext::unknownReference(const std::string& property, const std::string& what, const std::string& name,
                                      SourceRange range, bool literal, const std::vector<std::string>& candidates) {
    UnknownName& unknown = m_unknownNames[what + " " + name];
    if (unknown.reports == kMaxFollowUps) {
        if (unknown.last) ++diagnostics.at(unknown.last - 1).followUps;
        return;
    }
    ++unknown.reports;
    Diagnostic& d =
        diagnostics.error(Code::UnknownReference, range, property + " names " + name + ", but there is no such " + what);
    if (&d == &diagnostics.all().back()) unknown.last = diagnostics.all().size();
    if (manyAlready(diagnostics)) return;
    const std::vector<std::string> beside = besideIt(name, candidates);
    std::vector<std::string> near = meant(name, candidates, !beside.empty());
    if (candidates.empty()) d.message = property + " names " + name + ", but there is no " + what + " here";
    else if (near.empty()) {
        const std::vector<std::string>& all = beside.empty() ? candidates : beside;
        d.message += "; there " + std::string(all.size() == 1 ? "is " : "are ") + listText(all, "and");
    }
    suggestWords(d, std::move(near), literal ? range : SourceRange{});
}

bool ResolveContext::checkReference(const Property& property, const std::string& name, SourceRange range, bool literal,
                                    const PartFrame& frame, const GivenElement* given, const NotMeant& notMeant) {
    const std::vector<std::string>& choices = property.choices;
    if (name == "world" && takesWorld(property, frame)) return true;
    if (std::count(choices.begin(), choices.end(), "AntennaPattern")) { // at the top level, or an antenna model
        if (outline.patterns.find(name) || antennaModelNamed(name) || outline.unknown.count(name)) return true;
        unknownReference(property.name, "AntennaPattern", name, range, literal, outline.patterns.names());
        return false;
    }
    const bool geoms = wantsGeom(registry, choices);
    const Part* part = frame.find(name);
    std::vector<std::string> kinds = choices;
    std::erase(kinds, "world");
    const std::string what = geoms ? "geom (body.geom)" : kinds.empty() ? "thing" : listText(kinds);
    const std::size_t before = diagnostics.all().size();
    if (!part) {
        if (frame.isOpen && given) return false; // it may name something where the part is used
        const Part* around = frame.frameOf(firstWord(name)).config;
        const Part* first = around ? around->find(firstWord(name)) : nullptr;
        const bool unknown = first && (!first->kind || (first->isPartUse() && !first->config));
        if (unknown && firstWord(name) != name) return false; // reported at its block
        std::vector<std::string> names =
            manyAlready(diagnostics) ? std::vector<std::string>() : FittingNames(property, geoms).in(frame);
        notMeant.eraseFrom(names);
        unknownReference(property.name, what, name, range, literal, names);
        if ((frame.isOpen || frame.use) && !given && !first && name != "world" && diagnostics.all().size() > before)
            diagnostics.at(before).message +=
                "; what is outside of a PartConfig comes in by a Param, " + property.name + "=$" + std::string(lastWord(name));
        return false;
    }
    if (!part->kind) return false; // reported at its block
    if (kindFits(*part, choices)) return part->usable;
    Diagnostic& d = diagnostics.error(Code::UnknownReference, range,
                                      property.name + " names " + name + ", " + withArticle(part->kind->name) + "; it takes " +
                                          withArticle(what));
    if (manyAlready(diagnostics)) return false;
    std::vector<std::string> candidates = FittingNames(property, geoms).in(frame);
    notMeant.eraseFrom(candidates);
    std::vector<std::string> near = insideFirst(name, candidates);
    if (near.empty() && !candidates.empty()) d.message += ": " + listText(candidates);
    if (near.size() > 3) near.resize(3);
    suggestWords(d, std::move(near), literal ? range : SourceRange{});
    return false;
}

bool ResolveContext::checkReferences(Record& record, const Part& config) {
    PartFrame frame;
    frame.config = &config;
    return checkReferences(record, frame);
}

bool ResolveContext::checkReferences(Record& record, const PartFrame& frame) {
    bool good = true;
    for (std::size_t i = 0; i < record.values.size(); ++i) {
        const Property& property = record.kind->properties[i];
        if (property.type != PropertyType::Reference || !record.values[i]) continue;
        ResolvedValue& value = *record.values[i];
        if (value.origin == Origin::Default) continue; // an empty default means "none"
        const bool literal = record.literal[i] && (value.value.texts.size() == 1 || !value.names.empty());
        const auto names = record.names.find(i);
        const bool isWhole = names != record.names.end() && names->second.elements.size() == value.value.texts.size();
        const bool isAntenna = std::count(property.choices.begin(), property.choices.end(), "AntennaPattern") > 0;
        for (std::size_t k = 0; k < value.value.texts.size(); ++k) {
            std::string& name = value.value.texts[k];
            const GivenElement* given = isWhole ? &names->second.elements[k] : nullptr;
            const PartFrame& there = frameOf(frame, name, given);
            const std::size_t before = diagnostics.all().size();
            const bool isFromOutside = given && given->source.known() && (given->level > 0 || !given->literal);
            good = checkReference(property, name, isFromOutside ? given->source : value.rangeOf(k), literal || isFromOutside,
                                  there, given, {otherEnd(record, property.name), &there == &frame ? nullptr : frame.use}) &&
                   good;
            if (isFromOutside && diagnostics.all().size() > before)
                diagnostics.at(before).notes.emplace_back(kUsedHere, value.rangeOf(k));
            if (!isAntenna && name != "world") name = there.prefix + name;
        }
    }
    return good;
}

void reportTwo(ResolveContext& context, const Record& record, const Part& part, const char* first, const char* second,
               const std::string& message) {
    const bool isFirst = distanceOf(context, record, part, first) > distanceOf(context, record, part, second);
    const char* wrong = isFirst ? first : second;
    const SourceRange place = record.rangeOf(wrong, part.nameRange()), outside = record.givenOutside(wrong),
                      source = sourceOf(record, wrong);
    Diagnostic& d = context.diagnostics.error(Code::BadJoint, outside.known() ? outside : place, message);
    if (outside.known()) d.notes.emplace_back(kUsedHere, place);
    else if (source.known()) d.notes.emplace_back(kGivenHere, source);
}

std::optional<std::string> bodyOfIn(ResolveContext& context, const Record& record, const PartFrame& frame) {
    Record own = record; // without the config that a Part names, which is not looked up in a config
    for (std::size_t i = 0; i < own.values.size(); ++i)
        if (own.kind->properties[i].name != "In") own.values[i].reset();
    const ResolvedValue* value = own.find("In");
    if (!value || value->value.texts.empty()) return std::string();
    if (!frame.holder().config) {
        context.diagnostics.error(Code::WrongPlace, value->range,
                                  "In places what is in a config; at the top level there are no bodies to count from");
        return std::nullopt;
    }
    if (!context.checkReferences(own, frame)) return std::nullopt;
    const std::string& name = own.find("In")->value.texts[0];
    return name == "world" ? std::string() : name;
}

std::uint32_t ResolveContext::mirroredSurface(std::uint32_t surface) {
    SurfaceSpec mirrored = out.surfaces[surface];
    if (!mirrored.friction2 || mirrored.frictionHeading == 0) return surface;
    const auto [it, isNew] = m_mirrored.try_emplace(surface, static_cast<std::uint32_t>(out.surfaces.size()));
    if (!isNew) return it->second;
    const std::uint32_t image = it->second;
    m_mirrored.emplace(image, surface);
    mirrored.frictionHeading = -mirrored.frictionHeading;
    out.surfaces.push_back(std::move(mirrored));
    return image;
}

void ResolveContext::hintLater(const Part& found, const Part& user, SourceRange range) {
    if (found.order <= user.order || m_reportedLater[found.name]) return;
    if (outline.isInCircle(found)) return; // of those each is before another one
    m_reportedLater[found.name] = true;
    Diagnostic& d = diagnostics.hint(Code::DefinedLater, range, found.title() + " is defined after its first use");
    d.notes.push_back({"defined here", found.nameRange()});
}

std::uint32_t ResolveContext::lookUp(const Record& record, const Part& user, const char* key, const NameSpace& space,
                                     const std::map<std::string, std::uint32_t>& places) {
    const ResolvedValue* value = record.find(key);
    if (!value || value->value.texts.empty()) return 0;
    const std::string& name = value->value.texts[0];
    const auto it = places.find(name);
    if (it != places.end()) {
        if (const Part* part = space.find(name)) hintLater(*part, user, value->range);
        return it->second;
    }
    if (space.find(name) || outline.unknown.count(name)) return 0; // it exists but has errors of its own
    std::vector<std::string> names = manyAlready(diagnostics) ? std::vector<std::string>() : space.names();
    if (std::find(names.begin(), names.end(), "default") == names.end()) names.push_back("default");
    const bool literal = value->origin != Origin::Param;
    unknownReference(key, key, name, value->range, literal, names);
    return 0;
}

std::uint32_t ResolveContext::materialIndex(const Record& record, const Part& user) {
    return lookUp(record, user, "Material", outline.materials, materialPlaces);
}

std::uint32_t ResolveContext::surfaceIndex(const Record& record, const Part& user) {
    return lookUp(record, user, "Surface", outline.surfaces, surfacePlaces);
}

const Part* ResolveContext::configOf(const Record& record, const Part& user, std::string_view kind) {
    const ResolvedValue* value = record.find("Config");
    if (!value || value->value.texts.empty()) return nullptr;
    const std::string& name = value->value.texts[0];
    const bool literal = value->origin != Origin::Param;
    const auto names = [&] {
        std::vector<std::string> names;
        for (const Part* part : outline.configs.all())
            if (part->kind->name == kind && !manyAlready(diagnostics)) names.push_back(part->name);
        return names;
    };
    const Part* config = outline.configs.find(name);
    if (!config) {
        if (!outline.unknown.count(name)) unknownReference("Config", std::string(kind), name, value->range, literal, names());
        return nullptr;
    }
    if (config->kind->name != kind) {
        Diagnostic& d = diagnostics.error(Code::UnknownReference, value->range,
                                          "Config names " + name + ", " + withArticle(config->kind->name) + "; " +
                                              withArticle(user.kind->name) + " takes " + withArticle(kind));
        suggest(d, name, names(), literal ? value->range : SourceRange{});
        return nullptr;
    }
    hintLater(*config, user, value->range);
    return config;
}

} // namespace trundle
