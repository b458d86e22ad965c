#include "model/provenance.h"

#include <algorithm>

#include "model/config_blocks.h"
#include "model/dotted_path.h"
#include "model/params.h"
#include "model/robot_path.h"
#include "model/set_targets.h"

namespace trundle {

namespace {

std::string joined(std::span<const std::string> words) {
    std::string text;
    for (const std::string& word : words) text = pathInside(text, word);
    return text;
}

/// The same with the names of Repeats instead of those of their members: an override of all members.
std::string joinedForAll(const Part& config, std::span<const std::string> words) {
    std::string text;
    const Part* at = &config;
    for (const std::string& word : words) {
        at = at ? at->find(word) : nullptr;
        text = pathInside(text, at && at->isRepeat() ? at->name : word);
    }
    return text;
}

Provenance found(const Outline& outline, const SourceAssignment& a, Origin origin, const Property* property, SourceRange block) {
    const bool param = std::any_of(a.value->elements.begin(), a.value->elements.end(), [](const Element& e) {
        return e.kind == Element::Kind::ParamRef || e.kind == Element::Kind::Expression;
    });
    if (outline.texts().commandLine(a.file)) origin = Origin::CommandLine;
    else if (param) origin = Origin::Param;
    return {origin, a.valueRange(), block, property};
}

/// The provenance of a property that belongs to the part itself.
std::optional<Provenance> inPart(const Outline& outline, const Part& part, const std::string& key, Origin origin) {
    const Property* property = part.kind ? part.kind->find(key) : nullptr;
    if (!property) return std::nullopt;
    if (const SourceAssignment* a = part.assignments.find(key)) return found(outline, *a, origin, property, part.nameRange());
    return Provenance{Origin::Default, {}, part.nameRange(), property};
}

std::optional<Provenance> fromInstance(const Outline& outline, const Part& instance, std::span<const std::string> words,
                                       Origin origin);

std::optional<Provenance> fromPart(const Outline& outline, const Part& part, std::span<const std::string> words, Origin origin) {
    if (words.size() == 1) return inPart(outline, part, words[0], origin);
    if (isVariant(part) && part.config->find(words[0])) return fromInstance(outline, part, words, origin);
    const Part* inner = part.find(words[0]);
    if (!inner) return std::nullopt;
    const std::span<const std::string> rest = words.subspan(1);
    return inner->isPartUse() ? fromInstance(outline, *inner, rest, origin) : fromPart(outline, *inner, rest, origin);
}

/// `origin`: of what the instance's own block sets.
std::optional<Provenance> fromInstance(const Outline& outline, const Part& instance, std::span<const std::string> words,
                                       Origin origin) {
    const bool hasNoBlocks = instance.isPartUse() || isVariant(instance); // none with that name
    std::optional<Provenance> own = words.size() == 1 ? inPart(outline, instance, words[0], origin)
                                    : hasNoBlocks     ? std::nullopt
                                                      : fromPart(outline, instance, words, origin);
    if (own) return own;
    const Part* config = configOf(outline, instance);
    std::optional<Provenance> inConfig = config ? fromPart(outline, *config, words, Origin::Config) : std::nullopt;
    const SourceAssignment* a = instance.assignments.find(joined(words));
    if (!a && config) a = instance.assignments.find(joinedForAll(*config, words));
    if (!inConfig || !a) return inConfig;
    return found(outline, *a, origin, inConfig->property, instance.nameRange());
}

} // namespace

const Part* configOf(const Outline& outline, const Part& instance) {
    if (instance.isPartUse()) return instance.config;
    const SourceAssignment* a = instance.assignments.find("Config");
    if (!a || a->value->elements.size() != 1) return nullptr;
    const Element& e = a->value->elements[0];
    if (e.kind == Element::Kind::Word || e.kind == Element::Kind::String) return outline.configs.find(e.text);
    Diagnostics silent;
    Evaluator evaluator(outline.texts(), silent);
    ParamScope globals, own(&globals);
    globals.declare(outline.params);
    own.declare(instance.params);
    const std::optional<GivenValue> value = evaluator.evaluate(*a->value, a->file, own);
    return value && value->elements.size() == 1 ? outline.configs.find(value->elements[0].text) : nullptr;
}

std::optional<Provenance> provenanceOf(const Outline& outline, std::string_view path) {
    const DottedPath dotted(path);
    const std::vector<std::string>& words = dotted.words();
    if (words.empty()) return std::nullopt;
    if (words.size() == 1) {
        const Kind* settings = outline.registry().find("settings");
        const Property* property = settings ? settings->find(words[0]) : nullptr;
        if (!property) return std::nullopt;
        if (const SourceAssignment* a = outline.settings.find(words[0])) return found(outline, *a, Origin::Config, property, {});
        return Provenance{Origin::Default, {}, {}, property};
    }
    const Part* part = nullptr;
    std::size_t used = 1;
    if (const LayoutMember member = layoutMemberIn(outline, path); member.layout) {
        part = member.layout;
        used = DottedPath(member.name).words().size();
    } else {
        const PathStart start = startOfPath(outline, words);
        part = start.part;
        used = start.words;
    }
    if (!part || used >= words.size()) return std::nullopt;
    const std::span<const std::string> rest = std::span(words).subspan(used);
    const bool instance = part->is(Role::Instance) || part->is(Role::Layout);
    return instance ? fromInstance(outline, *part, rest, Origin::Instance) : fromPart(outline, *part, rest, Origin::Config);
}

} // namespace trundle
