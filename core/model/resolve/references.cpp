// Checks references by name: existence and kind of the target, with suggestions.

#include <algorithm>

#include "base/spelling.h"
#include "model/config_blocks.h"
#include "model/dotted_path.h"
#include "model/name_walk.h"
#include "model/resolve/reference_check.h"
#include "model/resolve/resolve_steps.h"
#include "schema/value_words.h"

namespace trundle {

namespace {

constexpr int kMaxFollowUps = 3; ///< number of reports of one unknown name

/// Where a value is written that a Param has brought in; not known for others.
SourceRange sourceOf(const Record& record, std::string_view property) {
    for (const auto& [index, value] : record.names)
        if (record.kind->properties[index].name == property && value.elements.size() == 1) return value.elements[0].source;
    return {};
}

/// Where a name is reported: one that a Param has brought in where that is written.
SourceRange placeOfName(const Record& record, std::string_view property, const ResolvedValue& value) {
    const SourceRange source = sourceOf(record, property);
    return source.known() ? source : value.range;
}

/// Where it is used, for the diagnostic with index `at` if that has been kept.
void addUseNote(Diagnostics& diagnostics, std::size_t at, const SourceRange& place, const ResolvedValue& value) {
    if (place != value.range && diagnostics.all().size() > at) diagnostics.at(at).notes.emplace_back(kUsedHere, value.range);
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

/// `m_0.wheel` in the member that `name` names, `m_2.wheel` for `m_2.whel`.
std::string inMember(const std::string& candidate, std::string_view name) {
    const std::string first(firstWord(candidate)), wanted(firstWord(name));
    const std::optional<MemberName> member = memberName(first), other = memberName(wanted);
    return member && other && member->stem == other->stem ? wanted + candidate.substr(first.size()) : candidate;
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

} // namespace

void ResolveContext::unknownReference(const std::string& property, const std::string& what, const std::string& name,
                                      SourceRange range, bool literal, const std::vector<std::string>& candidates) {
    UnknownName& unknown = m_unknownNames[what + " " + name];
    if (unknown.reports == kMaxFollowUps) {
        if (unknown.last) ++diagnostics.at(unknown.last - 1).followUps;
        return;
    }
    const auto lacksName = [&](const Diagnostic& each) {
        return each.code == Code::MissingName && each.range.file == range.file;
    };
    if (candidates.empty() && std::ranges::any_of(diagnostics.all(), lacksName)) return; // it is that one
    const std::size_t at = diagnostics.all().size();
    Diagnostic& d =
        diagnostics.error(Code::UnknownReference, range, property + " names " + name + ", but there is no such " + what);
    if (diagnostics.all().size() == at) return; // that place is reported already
    ++unknown.reports;
    unknown.last = diagnostics.all().size();
    if (manyAlready(diagnostics)) return;
    if (name.starts_with('$')) { // `Material="$look"`
        d.message = property + " names \"" + name + "\", a text; a Param is written without quotes, " + name;
        return suggestWords(d, {name}, literal ? range : SourceRange{});
    }
    const std::vector<std::string> beside = besideIt(name, candidates);
    std::vector<std::string> near = meant(name, candidates, !beside.empty());
    for (std::string& word : near) word = inMember(word, name);
    std::erase(near, name); // which is there in another config
    if (candidates.empty()) d.message = property + " names " + name + ", but there is no " + what + " here";
    else if (near.empty()) {
        const std::vector<std::string>& all = beside.empty() ? candidates : beside;
        d.message += "; there " + std::string(all.size() == 1 ? "is " : "are ") + listText(all, "and");
    }
    suggestWords(d, std::move(near), literal ? range : SourceRange{});
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

std::optional<std::string> bodyOfIn(ResolveContext& context, const Record& record, const PartFrame& frame,
                                    const std::string& self) {
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
    if (!checkReferences(context, own, frame, self)) return std::nullopt;
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
    if (range.file == found.file && range.range.begin > found.range.range.end) return; // the value of an override
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
    if (isReported(name) || space.find(name)) return 0; // it exists but has errors of its own
    std::vector<std::string> names = manyAlready(diagnostics) ? std::vector<std::string>() : space.names();
    if (std::find(names.begin(), names.end(), "default") == names.end()) names.push_back("default");
    const SourceRange place = placeOfName(record, key, *value);
    const bool literal = value->origin != Origin::Param || place != value->range;
    const std::size_t at = diagnostics.all().size();
    unknownReference(key, key, name, place, literal, names);
    addUseNote(diagnostics, at, place, *value);
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
    const SourceRange place = placeOfName(record, "Config", *value);
    const bool literal = value->origin != Origin::Param || place != value->range;
    const std::size_t at = diagnostics.all().size();
    const auto names = [&] {
        std::vector<std::string> names;
        for (const Part* part : outline.configs.all())
            if (part->kind->name == kind && !manyAlready(diagnostics)) names.push_back(part->name);
        return names;
    };
    const Part* config = outline.configs.find(name);
    if (!config) {
        if (!isReported(name)) unknownReference("Config", std::string(kind), name, place, literal, names());
        addUseNote(diagnostics, at, place, *value);
        return nullptr;
    }
    if (config->kind->name != kind) {
        Diagnostic& d = diagnostics.error(Code::UnknownReference, place,
                                          "Config names " + name + ", " + withArticle(config->kind->name) + "; " +
                                              withArticle(user.kind->name) + " takes " + withArticle(kind));
        suggest(d, name, names(), literal ? place : SourceRange{});
        addUseNote(diagnostics, at, place, *value);
        return nullptr;
    }
    hintLater(*config, user, value->range);
    return config;
}

} // namespace trundle
