#include "project/objects/path_scopes.h"

#include "model/config_blocks.h"
#include "model/dotted_path.h"
#include "model/repeat.h"

namespace trundle {

PathScopes::PathScopes(const LoadedProject& loaded, const ObjectLocation& place)
    : m_object(place.part), m_evaluator(loaded.outline->texts(), m_silent) {
    m_globals = m_scope = inside(nullptr, loaded.outline->params);
    std::vector<const Part*> chain = place.above;
    if (place.part) chain.push_back(place.part);
    const bool isReached = place.instance && isPlaced(*place.instance) && !place.instance->isPartUse() && !chain.empty() &&
                           chain.front() != place.instance;
    if (isReached) {
        for (const Part* repeat : place.around) m_scope = enterMember(*repeat, place.memberOf(*repeat).value_or(0));
        m_layers.push_back({place.instance, configOf(loaded, *place.instance),
                            enterMember(*place.instance, place.memberOf(*place.instance).value_or(0))});
    }
    const Part* before = nullptr;
    for (const Part* part : chain) {
        const bool isBase = before && isVariant(*before) && before->config == part; // its blocks are in the scope of the variant
        before = part;
        if (part->is(Role::Config)) {
            if (!isBase) m_scope = enter(*part);
            if (isVariant(*part)) m_layers.push_back({part, part->config, m_scope, m_path.size()});
            continue;
        }
        if (part != chain.front()) descend(*part, place);
        m_scope = enterMember(*part, place.memberOf(*part).value_or(0));
        if (isPlaced(*part)) m_layers.push_back({part, configOf(loaded, *part), m_scope, m_path.size()});
    }
}

void PathScopes::descend(const Part& part, const ObjectLocation& place) {
    const std::optional<std::size_t> member = part.isRepeat() ? place.memberOf(part) : std::nullopt;
    if (member) m_path.push_back({part.name + "_" + std::to_string(*member), part.name});
    else m_path.push_back({part.name, {}});
}

/// The Params of a block, and of a Repeat, Grid or Scatter the number of a member.
ParamScope* PathScopes::enterMember(const Part& part, std::size_t member) {
    ParamScope* outer = m_scope;
    if (part.isRepeat() || part.is(Role::Layout)) {
        ParamScope own(outer);
        own.declare(part.params);
        const std::vector<double> counts = countsOf(part, m_evaluator, own, nullptr, m_silent);
        outer = inside(m_scope, {});
        setIndex(*outer, member, counts);
    }
    return inside(outer, part.params);
}

ParamScope* PathScopes::inside(ParamScope* outer, const std::vector<SourceParam>& params) {
    ParamScope& scope = m_scopes.emplace_back(outer);
    scope.declare(params);
    return &scope;
}

/// The Params of a config, with what the instances on the path set.
ParamScope* PathScopes::enter(const Part& config) {
    ParamScope* scope = inside(m_globals, config.params);
    if (m_layers.empty() || m_layers.back().config != &config) return scope;
    for (const SourceParam& param : config.params) {
        const std::string& name = param.name->text;
        if (m_layers.back().instance->kind && m_layers.back().instance->kind->find(name)) continue;
        const std::optional<Override> set = overrideOf(name, true);
        if (!set) continue;
        if (const auto value = m_evaluator.evaluate(*set->assignment->value, set->assignment->file, *set->layer->scope))
            scope->preset(name, *value);
    }
    return scope;
}

ParamScope& PathScopes::configScope() {
    const bool isInstance = m_object && isPlaced(*m_object) && !m_layers.empty() && m_layers.back().config;
    if (isInstance && !m_configScope) m_configScope = enter(*m_layers.back().config);
    return m_configScope ? *m_configScope : *m_scope;
}

std::optional<PathScopes::Override> PathScopes::overrideOf(std::string_view key, bool isParam) const {
    const std::vector<Override> all = overridesOf(key, isParam);
    return all.empty() ? std::nullopt : std::optional(all.front());
}

std::vector<PathScopes::Override> PathScopes::overridesOf(std::string_view key, bool isParam) const {
    std::vector<OverrideLayer> layers;
    for (const Layer& layer : m_layers)
        if (isParam || layer.first < m_path.size()) layers.push_back({layer.instance, layer.first});
    std::vector<OverrideWord> path = m_path;
    path.push_back({std::string(key), {}});
    std::vector<Override> all;
    for (const FoundOverride& found : overridesFor(path, layers)) // the layers left out are the innermost ones
        all.push_back({found.assignment, &m_layers[found.layer]});
    return all;
}

} // namespace trundle
