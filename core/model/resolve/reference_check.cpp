// Checks the names that the blocks of a config name each other by: existence and kind of what is named.
#include "model/resolve/reference_check.h"

#include <algorithm>

#include "base/spelling.h"
#include "model/dotted_path.h"
#include "model/name_walk.h"
#include "model/resolve/resolve_steps.h"
#include "schema/value_words.h"

namespace trundle {

namespace {

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

constexpr double kMisspelt = 2; // as of "h1" and "h10"

/// First what is inside: `chassis.bumper` for `chassis`.
std::vector<std::string> insideFirst(const std::string& name, const std::vector<std::string>& candidates) {
    std::vector<std::string> near;
    for (const std::string& candidate : candidates)
        if (candidate.starts_with(name + ".")) near.push_back(candidate);
    for (const std::string& word : nearestWords(name, candidates))
        if (!std::count(near.begin(), near.end(), word)) near.push_back(word);
    return near;
}

/// For what exists, but is of another kind: `left` is not a misspelt `right`, and what is inside of it or around it may be meant.
bool mayBeMeant(const std::string& name, const std::string& candidate) {
    const bool isNested = candidate.starts_with(name + ".") || name.starts_with(candidate + ".");
    return isNested || spellingDistance(name, candidate) <= kMisspelt;
}

/// Names that a reference cannot mean: what the other end of the joint names, and what is in the Part that gives it.
struct NotMeant {
    std::string otherEnd;
    const Part* part; ///< nullptr: none
    std::string self; ///< the block that has the reference, where it cannot mean itself; empty: it can

    void eraseFrom(std::vector<std::string>& names) const;
};

void NotMeant::eraseFrom(std::vector<std::string>& names) const {
    const auto isIn = [](const std::string& name, const std::string& block) {
        return name == block || name.starts_with(block + ".") ||
               (name.starts_with(block + "_") && isMemberOf(firstWord(name), block));
    };
    std::erase_if(names, [&](const std::string& name) {
        return name == otherEnd || (part && name.starts_with(part->name + ".")) || (!self.empty() && isIn(name, self));
    });
}

/// One name of a value.
struct SaidName {
    const Property& property; ///< which defines the accepted kinds
    const std::string& name;
    SourceRange range;
    bool literal = false;
    const GivenElement* given = nullptr; ///< of a name that comes from a Param
    NotMeant notMeant;

    [[nodiscard]] SourceRange writable() const { return literal ? range : SourceRange{}; }
    [[nodiscard]] bool isOfGeom(const Registry& registry) const { return wantsGeom(registry, property.choices); }
    [[nodiscard]] std::string wanted(const Registry& registry) const {
        std::vector<std::string> kinds = property.choices;
        std::erase(kinds, "world");
        return isOfGeom(registry) ? "geom (body.geom)" : kinds.empty() ? "thing" : listText(kinds);
    }
};

class ReferenceCheck {
public:
    ReferenceCheck(ResolveContext& context, const PartFrame& frame) : m_context(context), m_frame(frame) {}

    [[nodiscard]] bool all(Record& record, const std::string& self);

private:
    [[nodiscard]] bool one(const SaidName& said, const PartFrame& frame);
    [[nodiscard]] bool isMissingMember(const SaidName& said, const PartFrame& frame);
    void unknown(const SaidName& said, const PartFrame& frame);
    void wrongKind(const SaidName& said, const PartFrame& frame, const Part& part);
    [[nodiscard]] std::vector<std::string> fitting(const SaidName& said, const PartFrame& frame) const {
        if (manyAlready(m_context.diagnostics)) return {};
        std::vector<std::string> names = FittingNames(said.property, said.isOfGeom(m_context.registry)).in(frame);
        said.notMeant.eraseFrom(names);
        return names;
    }

    ResolveContext& m_context;
    const PartFrame& m_frame;
};

bool ReferenceCheck::one(const SaidName& said, const PartFrame& frame) {
    const std::vector<std::string>& choices = said.property.choices;
    if (said.name == "world" && takesWorld(said.property, frame)) return true;
    if (std::count(choices.begin(), choices.end(), "AntennaPattern")) { // at the top level, or an antenna model
        const NameSpace& patterns = m_context.outline.patterns;
        if (patterns.find(said.name) || antennaModelNamed(said.name) || m_context.isReported(said.name)) return true;
        m_context.unknownReference(said.property.name, "AntennaPattern", said.name, said.range, said.literal, patterns.names());
        return false;
    }
    const Part* part = frame.find(said.name);
    if (!part) unknown(said, frame);
    if (!part || !part->kind) return false; // reported at its block
    if (kindFits(*part, choices)) return part->usable;
    wrongKind(said, frame, *part);
    return false;
}

void ReferenceCheck::unknown(const SaidName& said, const PartFrame& frame) {
    const auto& [property, name, range, literal, given, notMeant] = said;
    if (name == "world") {
        const bool isChild = property.name == "Child";
        m_context.diagnostics.error(Code::UnknownReference, range,
                                    property.name + " cannot be the world" + (isChild ? ", a Parent can: exchange the two" : ""));
        return;
    }
    if (frame.isUnfinished(name) || isMissingMember(said, frame) || (frame.isOpen && given))
        return; // it may name something where the part is used
    const Part* around = frame.frameOf(firstWord(name)).config;
    const Part* first = around ? around->find(firstWord(name)) : nullptr;
    const bool isBroken = first && (!first->kind || (first->isPartUse() && !first->config));
    if (isBroken && firstWord(name) != name) return; // reported at its block
    const std::size_t before = m_context.diagnostics.all().size();
    m_context.unknownReference(property.name, said.wanted(m_context.registry), name, range, literal, fitting(said, frame));
    if ((!frame.isOpen && !frame.holder().use) || given || first || m_context.diagnostics.all().size() == before) return;
    Diagnostic& d = m_context.diagnostics.at(before);
    const std::string param = "$" + std::string(lastWord(name));
    d.message += "; what is outside of a PartConfig comes in by a Param, " + property.name + "=" + param;
    const Part* config = frame.holder().config;
    if (d.suggestions.empty() && config && config->param(name)) suggestWords(d, {param}, said.writable()); // its Parts give it
}

/// Whether a name is that of something in a member that a Repeat does not have; reports it.
bool ReferenceCheck::isMissingMember(const SaidName& said, const PartFrame& frame) {
    const std::string first(firstWord(said.name));
    const std::optional<MemberName> member = memberName(first);
    if (!member) return false;
    const PartFrame* at = &frame;
    while (at->member && at->outer && !at->config->find(member->stem)) at = at->outer;
    const Part* repeat = at->config ? at->config->find(member->stem) : nullptr;
    if (!repeat || !repeat->isRepeat() || at->inner.contains(first)) return false;
    std::string last;
    for (std::size_t k = 0; k < member->index; ++k) {
        std::string each = repeat->name + "_" + std::to_string(k);
        if (!at->inner.contains(each)) break;
        last = std::move(each);
    }
    if (last.empty()) return false;
    Diagnostic& d = m_context.diagnostics.error(Code::UnknownReference, said.range,
                                                said.property.name + " names " + said.name + ", but " + repeat->title() +
                                                    " has no member " + first + "; the last one is " + last);
    suggestWords(d, {last + said.name.substr(first.size())}, said.writable());
    return true;
}

void ReferenceCheck::wrongKind(const SaidName& said, const PartFrame& frame, const Part& part) {
    Diagnostic& d = m_context.diagnostics.error(Code::UnknownReference, said.range,
                                                said.property.name + " names " + said.name + ", " + withArticle(part.kind->name) +
                                                    "; it takes " + withArticle(said.wanted(m_context.registry)));
    if (manyAlready(m_context.diagnostics)) return;
    const std::vector<std::string> candidates = fitting(said, frame);
    std::vector<std::string> near = insideFirst(said.name, candidates);
    std::erase_if(near, [&](const std::string& name) { return !mayBeMeant(said.name, name); });
    if (near.empty() && !candidates.empty()) d.message += ": " + listText(candidates);
    if (near.size() > 3) near.resize(3);
    suggestWords(d, std::move(near), said.writable());
}

bool ReferenceCheck::all(Record& record, const std::string& self) {
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
            const PartFrame& there = frameOf(m_frame, name, given);
            const std::size_t before = m_context.diagnostics.all().size();
            const bool isFromOutside = given && given->source.known() && (given->level > 0 || !given->literal);
            const NotMeant notMeant{otherEnd(record, property.name), &there == &m_frame ? nullptr : m_frame.use, self};
            const SourceRange place = isFromOutside ? given->source : value.rangeOf(k);
            good = one({property, name, place, literal || isFromOutside, given, notMeant}, there) && good;
            if (isFromOutside && m_context.diagnostics.all().size() > before)
                m_context.diagnostics.at(before).notes.emplace_back(kUsedHere, value.rangeOf(k));
            if (!isAntenna && name != "world") name = there.prefix + name;
        }
    }
    return good;
}

} // namespace

std::string otherEnd(const Record& record, std::string_view property) {
    const ResolvedValue* other = property == "Child"    ? record.find("Parent")
                                 : property == "Parent" ? record.find("Child")
                                                        : nullptr;
    return other && other->value.texts.size() == 1 ? other->value.texts[0] : std::string();
}

bool checkReferences(ResolveContext& context, Record& record, const PartFrame& frame, const std::string& self) {
    return ReferenceCheck(context, frame).all(record, self);
}

bool checkReferences(ResolveContext& context, Record& record, const Part& config) {
    PartFrame frame;
    frame.config = &config;
    return checkReferences(context, record, frame);
}

} // namespace trundle
