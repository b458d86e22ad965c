#include "model/provenance.h"

#include <algorithm>

#include "model/config_blocks.h"
#include "model/dotted_path.h"
#include "model/override_order.h"
#include "model/params.h"
#include "model/robot_path.h"
#include "model/set_targets.h"

namespace trundle {

namespace {

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

/// Follows a path, and collects the blocks on it that set values of what is inside them.
class ProvenanceSearch {
public:
    ProvenanceSearch(const Outline& outline, std::span<const std::string> words) : m_outline(outline) {
        for (const std::string& word : words) m_path.push_back({word, {}});
    }

    std::optional<Provenance> run(const Part& part) {
        const bool isInstance = part.is(Role::Instance) || part.is(Role::Layout);
        const std::optional<Provenance> inside =
            isInstance ? fromInstance(part, 0, Origin::Instance) : fromPart(part, 0, Origin::Config);
        const std::vector<FoundOverride> all = inside ? overridesFor(m_path, m_layers) : std::vector<FoundOverride>();
        if (all.empty()) return inside;
        const FoundOverride& held = all.front();
        const SourceRange block = m_layers[held.layer].instance->nameRange();
        return found(m_outline, *held.assignment, m_origins[held.layer], inside->property, block);
    }

private:
    bool isLast(std::size_t word) const { return word + 1 == m_path.size(); }

    std::optional<Provenance> fromPart(const Part& part, std::size_t word, Origin origin) {
        OverrideWord& at = m_path[word];
        if (isLast(word)) return inPart(m_outline, part, at.name, origin);
        if (isVariant(part) && part.config->find(at.name)) return fromInstance(part, word, origin);
        const Part* inner = part.find(at.name);
        if (!inner) return std::nullopt;
        at.all = inner->isRepeat() && inner->name != at.name ? inner->name : std::string();
        return inner->isPartUse() ? fromInstance(*inner, word + 1, origin) : fromPart(*inner, word + 1, origin);
    }

    /// `origin`: of what the instance's own block sets.
    std::optional<Provenance> fromInstance(const Part& instance, std::size_t word, Origin origin) {
        const bool hasNoBlocks = instance.isPartUse() || isVariant(instance); // none with that name
        std::optional<Provenance> own = isLast(word)  ? inPart(m_outline, instance, m_path[word].name, origin)
                                        : hasNoBlocks ? std::nullopt
                                                      : fromPart(instance, word, origin);
        if (own) return own;
        const Part* config = configOf(m_outline, instance);
        if (!config) return std::nullopt;
        m_layers.push_back({&instance, word});
        m_origins.push_back(origin);
        return fromPart(*config, word, Origin::Config);
    }

    const Outline& m_outline;
    std::vector<OverrideWord> m_path;
    std::vector<OverrideLayer> m_layers;
    std::vector<Origin> m_origins; ///< of what each layer sets
};

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
    return ProvenanceSearch(outline, rest).run(*part);
}

} // namespace trundle
