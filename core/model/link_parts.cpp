// Leads every Part to the PartConfig that it names and every variant to the config that it is a variant of, and finds the Params that references to something outside of a PartConfig
// imply: `Parent=$carrier`, where no text declares carrier.
#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "base/spelling.h"
#include "model/config_blocks.h"
#include "model/outline.h"
#include "model/params.h"
#include "model/part_depth.h"

namespace trundle {

namespace {

/// Whether it names a body, joint, device or geom of a config, and not a Material or Robot. A joint may also be in the world.
bool namesInsideConfig(const Registry& registry, const Outline& outline, const Property& property) {
    if (property.type != PropertyType::Reference) return false;
    return std::ranges::none_of(property.choices, [&](const std::string& choice) {
        const Kind* kind = registry.find(choice);
        return kind && kind->role != Role::Joint && outline.spaceOf(*kind);
    });
}

/// A variant has the Params of what it is a variant of, with the values that it sets for them.
void inheritParams(const Outline& outline, Part& variant) {
    for (const SourceParam& param : variant.config->params) {
        const SourceAssignment* set = variant.assignments.find(param.name->text);
        const auto own =
            std::ranges::find_if(variant.params, [&](const SourceParam& p) { return p.name->text == param.name->text; });
        const bool isSet = own != variant.params.end() && outline.texts().commandLine(own->valueFile);
        if (own != variant.params.end() && (own->name != param.name || isSet)) continue; // a clash, or set on the command line
        SourceParam& inherited = own != variant.params.end() ? *own : variant.params.emplace_back();
        inherited = param;
        if (!set) continue;
        inherited.value = set->value;
        inherited.valueFile = set->file;
        inherited.required = false;
    }
}

class ImpliedParams {
public:
    explicit ImpliedParams(const Outline& outline) : m_outline(outline) {
        for (const auto& part : outline.parts) collectGiven(*part);
    }

    /// Adds them to a PartConfig, and to any variant those of what it is a variant of.
    void add(Part& config) {
        if (!m_visited.insert(&config).second) return;
        if (config.config) {
            add(const_cast<Part&>(*config.config));
            inheritParams(m_outline, config);
        }
        if (config.kind->name != "PartConfig") return;
        std::vector<const Part*> around = std::exchange(m_holders, {}); // what uses it has names of its own
        searchIn(config, config);
        m_holders = std::move(around);
    }

private:
    void collectGiven(const Part& part) {
        for (const SourceAssignment& a : part.assignments.all()) {
            if (a.path.size() > 1) m_givenByPath.insert(a.path.back().text);
            else if (part.kind && !part.kind->find(a.key))
                for (const Part* config = part.config; config; config = config->config) ++m_given[config][a.key];
        }
        for (const Part& inner : part.parts) collectGiven(inner);
    }
    bool isGivenByPart(const Part& config, const std::string& name) const {
        const auto given = m_given.find(&config);
        return given != m_given.end() && given->second.contains(name);
    }
    bool isGivenWord(const Part& config, const Element& e) const {
        return e.kind == Element::Kind::Word && isGivenByPart(config, e.text);
    }
    bool isGiven(const Part& config, const std::string& name) const {
        return isGivenByPart(config, name) || m_givenByPath.contains(name);
    }
    /// What all Parts call a Param that the config spells otherwise; empty: nothing.
    std::string spelling(const Part& config, const std::string& name) const {
        constexpr std::size_t kMany = 1000;
        const auto given = m_given.find(&config);
        if (given == m_given.end() || given->second.size() > kMany) return {};
        const int least = isMisspelt(config, name) ? 1 : 2; // of one Part it is not known which of the two is wrong
        std::vector<std::string> others;
        for (const auto& [key, count] : given->second)
            if (count >= least && !config.param(key)) others.push_back(key);
        const std::vector<std::string> near = nearestWords(name, others);
        return near.empty() ? std::string() : near.front();
    }

    void searchIn(const Part& holder, Part& config) {
        m_holders.push_back(&holder);
        for (const Part& part : holder.parts) {
            if (part.isPartUse() && part.config) ImpliedParams::add(const_cast<Part&>(*part.config));
            if (part.isRepeat()) searchIn(part, config);
            if (!part.kind) continue;
            for (const SourceAssignment& a : part.assignments.all())
                if (a.path.size() == 1 && takesReference(part, a.key)) names(config, part, a);
        }
        m_holders.pop_back();
    }

    bool takesReference(const Part& part, const std::string& key) const {
        if (const Property* property = part.kind->find(key)) return namesInsideConfig(m_outline.registry(), m_outline, *property);
        const SourceParam* param = part.isPartUse() && part.config ? part.config->param(key) : nullptr;
        return param && (param->required || namesByParam(*part.config, key));
    }

    /// Whether a config names something inside of what uses it by a Param that has a default: `Parent=$carrier`.
    bool namesByParam(const Part& holder, const std::string& param) const {
        const auto [known, isNew] = m_named.try_emplace({&holder, param}, false);
        if (!isNew) return known->second;
        const auto isMeant = [&](const Element& e) { return e.kind == Element::Kind::ParamRef && e.text == param; };
        const bool names = std::ranges::any_of(holder.parts, [&](const Part& part) {
            if (part.isRepeat() && namesByParam(part, param)) return true;
            return part.kind && std::ranges::any_of(part.assignments.all(), [&](const SourceAssignment& a) {
                return a.path.size() == 1 && std::ranges::any_of(a.value->elements, isMeant) && takesReference(part, a.key);
            });
        });
        return m_named[{&holder, param}] = names;
    }

    void names(Part& config, const Part& part, const SourceAssignment& a) const {
        for (const Element& e : a.value->elements) {
            const bool isParam =
                e.kind == Element::Kind::ParamRef; // `Parent=carrier`, whose `$` is missing, is reported there alone
            if ((!isParam && !isGivenWord(config, e)) || config.param(e.text) || part.param(e.text)) continue;
            const auto isInside = [&](const Part* holder) {
                return holder->param(e.text) || std::ranges::find(holder->parts, e.text, &Part::name) != holder->parts.end();
            };
            if (std::ranges::any_of(m_holders, isInside)) continue; // `$wheel` for `wheel`
            if (!isParam) {
                imply(config, e.text, e.range, a.file, false);
                continue;
            }
            if (const SourceParam* global = globalName(e.text)) { // a default, which uses can change
                config.params.push_back(*global);
                continue;
            }
            const TextRange range{e.range.begin + 1, e.range.end};
            const std::string other = isGiven(config, e.text) ? std::string() : spelling(config, e.text);
            if (!other.empty()) imply(config, other, range, a.file, false); // `$carier` is reported there alone
            else if (isGiven(config, e.text) || !isMisspelt(config, e.text)) imply(config, e.text, range, a.file, true);
        }
    }

    static void imply(Part& config, const std::string& name, TextRange range, FileId file, bool required) {
        auto implied = std::make_shared<ImpliedParam>();
        implied->name = {name, range};
        implied->value.range = {range.end, range.end};
        config.params.push_back({&implied->name, &implied->value, file, file, nullptr, required});
        config.implied.push_back(std::move(implied));
    }

    /// Whether it is most likely one of the other Params.
    static bool isMisspelt(const Part& config, const std::string& name) {
        std::vector<std::string> declared;
        for (const SourceParam& param : config.params) declared.push_back(param.name->text);
        return !nearestWords(name, declared).empty();
    }

    /// A Param of the top level that names something; one that is a number is not meant.
    const SourceParam* globalName(const std::string& name) const {
        const auto it = std::ranges::find_if(m_outline.params, [&](const SourceParam& p) { return p.name->text == name; });
        const bool isName =
            it != m_outline.params.end() && it->value->elements.size() == 1 &&
            (it->value->elements[0].kind == Element::Kind::Word || it->value->elements[0].kind == Element::Kind::String);
        return isName ? &*it : nullptr;
    }

    const Outline& m_outline;
    std::unordered_set<const Part*> m_visited;
    /// What the Parts and variants of a config give but for their properties, and how many do.
    std::unordered_map<const Part*, std::map<std::string, int>> m_given;
    std::set<std::string> m_givenByPath;                                 ///< `left.carrier=...`: the last word
    mutable std::map<std::pair<const Part*, std::string>, bool> m_named; ///< results of namesByParam()
    std::vector<const Part*> m_holders; ///< the config that is searched and the Repeats around the place
};

/// Takes the config from the Parts that close a circle of PartConfigs, or nest them too deep.
class CircleSearch {
public:
    explicit CircleSearch(std::vector<Outline::PartCircle>& found) : m_found(found) {}

    void visit(Part& config) {
        if (!m_depths.try_emplace(&config, 1).second) return;
        m_chain.push_back(&config);
        if (config.config) follow(config, config);
        eachPartUse(config, [&](const Part& part) {
            if (part.config) follow(const_cast<Part&>(part), config);
        });
        m_chain.pop_back();
    }

private:
    void follow(Part& part, const Part& config) {
        const auto begin = std::ranges::find(m_chain, part.config);
        if (begin != m_chain.end()) {
            std::string chain;
            for (auto it = begin; it != m_chain.end(); ++it) chain += (*it)->name + " > ";
            return cut(part, chain + part.config->name);
        }
        if (m_chain.size() < kDeepestParts) visit(const_cast<Part&>(*part.config));
        const auto depth = m_depths.find(part.config);
        if (depth == m_depths.end() || depth->second >= kDeepestParts) return cut(part, {});
        m_depths[&config] = std::max(m_depths[&config], depth->second + 1);
    }
    void cut(Part& part, std::string chain) {
        m_found.push_back({&part, std::move(chain)});
        part.config = nullptr;
    }

    std::vector<Outline::PartCircle>& m_found;
    std::unordered_map<const Part*, std::size_t> m_depths; ///< of what was visited, with what is in it
    std::vector<const Part*> m_chain;
};

/// The names of the Parts whose config blocks around them exchange: `left.Config=BigWheel`.
void collectExchanged(const Part& part, std::unordered_set<std::string>& names) {
    for (const SourceAssignment& a : part.assignments.all())
        if (a.path.size() > 1 && a.path.back().text == "Config") names.insert(a.path[a.path.size() - 2].text);
    for (const Part& inner : part.parts) collectExchanged(inner, names);
}

} // namespace

void Outline::linkPart(Part& part, const Part* owner, bool isMisplaced) {
    // What a config has that is not at the top level is not linked: it may lead back to the config around it, without an end.
    isMisplaced = isMisplaced || (part.is(Role::Config) && (owner || !part.usable));
    const bool hasConfig = part.isPartUse() || part.is(Role::Config);
    if (hasConfig) part.config = nullptr;
    const SourceAssignment* a = hasConfig && !isMisplaced ? part.assignments.find("Config") : nullptr;
    if (a && a->value->elements.size() == 1) {
        const Element& e = a->value->elements[0];
        std::string name = e.text;
        if (e.kind == Element::Kind::ParamRef) {
            Diagnostics silent;
            Evaluator evaluator(*m_texts, silent);
            ParamScope globals, scope(&globals);
            globals.declare(params);
            if (owner) scope.declare(owner->params);
            const std::optional<GivenValue> value = evaluator.evaluate(*a->value, a->file, scope);
            name = value && value->elements.size() == 1 ? value->elements[0].text : std::string();
        }
        const Part* config = configs.find(name);
        if (config && config->kind->name == (part.isPartUse() ? "PartConfig" : part.kind->name)) part.config = config;
    }
    if (part.is(Role::Config) || part.isRepeat())
        for (Part& inner : part.parts) linkPart(inner, part.isRepeat() ? owner : &part, isMisplaced);
}

void Outline::linkParts() {
    for (const auto& part : parts) linkPart(*part, nullptr, false);
    m_circles.clear();
    CircleSearch circles(m_circles);
    for (const auto& part : parts)
        if (part->is(Role::Config)) circles.visit(*part);
    ImpliedParams implied(*this);
    for (const auto& part : parts)
        if (part->is(Role::Config)) implied.add(*part);
    m_exchanged.clear();
    for (const auto& part : parts) collectExchanged(*part, m_exchanged);
}

bool Outline::hasVaryingConfig(const Part& part) const {
    return part.isPartUse() && (isConfigComputed(part) || m_exchanged.contains(part.name));
}

bool Outline::isInCircle(const Part& config) const {
    return std::ranges::any_of(m_circles, [&](const PartCircle& circle) {
        return (" > " + circle.chain + " > ").find(" > " + config.name + " > ") != std::string::npos;
    });
}

} // namespace trundle
