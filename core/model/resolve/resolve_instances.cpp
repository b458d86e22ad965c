// Resolves Robots, Statics, Grids and Scatters: config, values, poses and controller. Instances with equal values share one
// resolved config.
#include <algorithm>

#include "base/spelling.h"
#include "model/kinds/world_fields.h"
#include "model/resolve/instance_variants.h"
#include "model/resolve/resolve_steps.h"
#include "schema/value_reader.h"
#include "schema/value_words.h"

namespace trundle {

namespace {

void appendKey(std::string& key, const std::string& name, const GivenValue& value) {
    key += '\n' + name + '=';
    for (const GivenElement& e : value.elements) {
        key += static_cast<char>('0' + static_cast<int>(e.kind));
        key += elementText(e) + e.text + ',';
    }
}

/// Values that an instance sets in its config.
struct InstanceValues {
    std::vector<std::pair<std::string, GivenValue>> params;
    OverrideNode overrides;
    std::string key; ///< identifies the values: equal keys for equal values
};

std::size_t countParts(const Part& part) {
    std::size_t count = 1;
    for (const Part& inner : part.parts) count += countParts(inner);
    return count;
}

class Instances {
public:
    explicit Instances(ResolveContext& context) : m_context(context) {}

    void run() {
        checkConfigs();
        for (const Part* part : m_context.outline.world.all()) {
            if (part->kind->name == "Static") addStatic(*part);
        }
        for (const Part* part : m_context.outline.world.all()) {
            if (part->kind->name == "Robot" || part->is(Role::Layout)) addRobots(*part);
        }
    }

    /// Resolves one Robot or Static only, with these Params instead of its own.
    void only(const Part& part, const InstanceVariants::Params& params) {
        m_params = &params;
        if (part.kind->name == "Static") addStatic(part);
        else addRobots(part);
    }

    InstanceVariants::Params paramsOf(const Part& part) {
        ParamScope scope(&m_context.globals), inner(&m_context.globals);
        scope.declare(part.params);
        InstanceValues given;
        const Part* config = nullptr;
        (void)readInstance(part, scope, given, config, part.kind->name == "Static" ? "StaticConfig" : "RobotConfig");
        if (!config) return {};
        inner.declare(config->params);
        for (const auto& [name, value] : given.params) inner.preset(name, value);
        InstanceVariants::Params all;
        for (const SourceParam& param : config->params) {
            const std::string& name = param.name->text;
            const auto set =
                std::find_if(given.params.begin(), given.params.end(), [&](const auto& p) { return p.first == name; });
            std::optional<GivenValue> value =
                set != given.params.end() ? set->second : m_context.evaluator.evaluate(*param.value, param.valueFile, inner);
            if (value) all.emplace_back(name, std::move(*value));
        }
        return all;
    }

private:
    /// Resolves every config with its own values, so that errors in unused ones are reported too.
    void checkConfigs() {
        for (const Part* part : m_context.outline.configs.all()) {
            if (part->kind->name == "RobotConfig") (void)robotConfig(*part, InstanceValues{});
            else (void)staticConfig(*part, InstanceValues{});
        }
    }

    /// The config that an instance probably names; reports no errors.
    const Part* likelyConfig(const Part& part, ParamScope& scope) {
        const SourceAssignment* a = part.assignments.find("Config");
        if (!a || a->value->elements.size() != 1) return nullptr;
        const Element& e = a->value->elements[0];
        if (e.kind == Element::Kind::Word || e.kind == Element::Kind::String) return m_context.outline.configs.find(e.text);
        Diagnostics silent;
        Evaluator trial(m_context.texts, silent);
        const std::optional<GivenValue> value = trial.evaluate(*a->value, a->file, scope);
        return value && value->elements.size() == 1 ? m_context.outline.configs.find(value->elements[0].text) : nullptr;
    }

    Record readInstance(const Part& part, ParamScope& scope, InstanceValues& given, const Part*& config, std::string_view kind) {
        const Part* likely = likelyConfig(part, scope);
        ResolveContext::ExtraKeys extra;
        if (likely) {
            for (const SourceParam& p : likely->params) extra.words.push_back(p.name->text);
            for (const Property& p : likely->kind->properties) extra.words.push_back(p.name);
        }
        std::vector<const SourceAssignment*> taken;
        extra.take = [&](const SourceAssignment& a) {
            if (a.path.size() == 1 && (!likely || (!likely->param(a.key) && !likely->kind->find(a.key)))) {
                const std::vector<std::string> own = propertyNames(*part.kind);
                return !likely && part.assignments.find("Config") &&
                       nearestWords(a.key, own).empty(); // of an unknown config the Params are unknown too
            }
            taken.push_back(&a);
            return true;
        };
        Record record = m_context.read(part, scope, nullptr, Origin::Instance, extra);
        config = m_context.configOf(record, part, kind);
        if (!config) return record;
        for (const SourceAssignment* a : taken) takeValue(part, *config, *a, scope, given);
        for (const auto& [name, value] : m_params ? *m_params : InstanceVariants::Params{}) {
            std::erase_if(given.params, [&, &name = name](const auto& p) { return p.first == name; });
            given.params.emplace_back(name, value);
            appendKey(given.key, name, value);
        }
        return record;
    }

    void takeValue(const Part& part, const Part& config, const SourceAssignment& a, ParamScope& scope, InstanceValues& given) {
        const bool param = a.path.size() == 1 && config.param(a.key);
        if (!param && a.path.size() > 1 && part.find(a.path[0].text)) {
            m_context.diagnostics.error(Code::NoSuchPath, a.keyRange(),
                                        "set " + a.key.substr(a.path[0].text.size() + 1) + " inside the block of " +
                                            a.path[0].text);
            return;
        }
        if (!param && !pathLeadsSomewhere(config, a)) return;
        std::optional<GivenValue> value = m_context.evaluator.evaluate(*a.value, a.file, scope);
        if (!value || (param && !m_context.evaluator.checkUnits(*value))) return;
        appendKey(given.key, a.key, *value);
        if (param) {
            value->fromParam = true;
            given.params.emplace_back(a.key, std::move(*value));
            return;
        }
        OverrideNode* node = &given.overrides;
        for (const Name& name : a.path) node = &node->children[name.text];
        node->origin = Origin::Instance;
        node->value = std::make_shared<const GivenValue>(std::move(*value));
    }

    bool pathLeadsSomewhere(const Part& config, const SourceAssignment& a) {
        const Part* part = &config;
        for (std::size_t i = 0; i + 1 < a.path.size(); ++i) {
            const Part* next = part->find(a.path[i].text);
            if (!next) return noSuchPath(*part, a, i);
            if (!next->kind) return false; // raw text of an unavailable module
            part = next;
        }
        return part->kind->find(a.path.back().text) || noSuchPath(*part, a, a.path.size() - 1);
    }

    bool noSuchPath(const Part& part, const SourceAssignment& a, std::size_t i) {
        std::vector<std::string> words;
        for (const Part& inner : part.parts) words.push_back(inner.name);
        if (i + 1 == a.path.size()) words = propertyNames(*part.kind);
        const SourceRange place{a.file, a.path[i].range};
        Diagnostic& d = m_context.diagnostics.error(Code::NoSuchPath, place, part.title() + " has no " + a.path[i].text);
        if (words.empty()) return false;
        d.message += "; it has " + listText(words, "and", 20);
        if (manyAlready(m_context.diagnostics)) return false;
        suggest(d, a.path[i].text, words, place);
        if (d.suggestions.empty() && i + 1 < a.path.size()) suggestWords(d, oneDeeper(part, a.path[i].text), place);
        return false;
    }

    /// Paths with one more level for a missing word: `chassis.hull.Size` for `hull.Size`.
    static std::vector<std::string> oneDeeper(const Part& part, const std::string& name) {
        std::vector<std::string> paths;
        for (const Part& inner : part.parts)
            if (inner.find(name)) paths.push_back(inner.name + "." + name);
        return paths;
    }

    /// Resolves a config with these values, or returns the cached result. Results with errors caused by an instance's values are
    /// not cached, so that every such instance gets its own diagnostics.
    template <class Spec, class Resolve>
    std::shared_ptr<const Spec> shared(std::map<std::string, std::shared_ptr<const Spec>>& cache, const Part& config,
                                       const InstanceValues& given, const Resolve& resolve) {
        const std::string key = config.name + given.key;
        const auto it = cache.find(key);
        if (it != cache.end()) return it->second;
        const std::size_t errors = m_context.diagnostics.errorCount(), said = m_context.diagnostics.all().size();
        ParamScope scope(&m_context.globals);
        scope.declare(config.params);
        for (const auto& [name, value] : given.params) scope.preset(name, value);
        m_context.evaluator.checkAll(scope);
        std::shared_ptr<const Spec> spec = resolve(m_context, config, scope, given.key.empty() ? nullptr : &given.overrides);
        if (given.key.empty() || m_context.diagnostics.errorCount() == errors) cache.emplace(key, spec);
        if (!given.key.empty()) nameInstance(said, given);
        return spec;
    }
    /// Moves the new diagnostics to the values of the instance that caused them; a value that is not known gets a note with the
    /// instance.
    void nameInstance(std::size_t said, const InstanceValues& given) {
        if (m_context.diagnostics.all().size() == said || manyAlready(m_context.diagnostics)) return;
        for (std::size_t i = said; i < m_context.diagnostics.all().size(); ++i) {
            Diagnostic& d = m_context.diagnostics.at(i);
            if (moveToValue(d, given)) continue;
            if (!inside(d.range, m_instance->range))
                d.notes.push_back({"with the values of " + m_instance->title(), m_instance->nameRange()});
        }
    }
    /// Its fixes are for the place in the config, which other instances use too.
    static bool moveToValue(Diagnostic& d, const InstanceValues& given) {
        if (d.notes.empty() || d.notes[0].first != kGivenHere) return false;
        const SourceRange value = d.notes[0].second;
        if (std::ranges::none_of(given.params, [&](const auto& p) { return inside(value, p.second.range); })) return false;
        d.notes[0] = {kUsedHere, d.range};
        d.range = value;
        d.fixes.clear();
        return true;
    }
    static bool inside(const SourceRange& a, const SourceRange& b) {
        return a.file == b.file && a.range.begin >= b.range.begin && a.range.end <= b.range.end;
    }

    std::shared_ptr<const RobotConfigSpec> robotConfig(const Part& config, const InstanceValues& given) {
        return shared(m_robots, config, given, resolveRobotConfig);
    }
    std::shared_ptr<const std::vector<GeomSpec>> staticConfig(const Part& config, const InstanceValues& given) {
        return shared(m_statics, config, given, resolveStaticConfig);
    }

    /// Checks the object count before anything is built; false, with a diagnostic, if there would be too many.
    bool roomFor(const Part& part, const Part& config, double members, SourceRange place) {
        const auto [it, fresh] = m_sizes.try_emplace(&config, 0);
        if (fresh) it->second = countParts(config);
        m_objects += members * static_cast<double>(it->second);
        if (m_objects <= static_cast<double>(kMaxObjects)) return true;
        if (!m_tooMany) {
            m_context.diagnostics.error(Code::TooManyObjects, place,
                                        "with " + part.title() + " the world would hold more than 200000 objects");
        }
        m_tooMany = true;
        return false;
    }

    void addStatic(const Part& part) {
        m_instance = &part;
        ParamScope scope(&m_context.globals);
        scope.declare(part.params);
        InstanceValues given;
        const Part* config = nullptr;
        const Record record = readInstance(part, scope, given, config, "StaticConfig");
        if (!config || !record.complete || !roomFor(part, *config, 1, part.nameRange())) return;
        const StaticFields f = fieldsFrom<StaticFields>(record);
        m_context.out.statics.push_back(
            {part.name, config->name, poseOf(f.pos, f.hpr), staticConfig(*config, given), part.range, part.nameRange()});
    }

    std::optional<ComponentSpec> controller(const Part& part, ParamScope& scope, const Part* config) {
        for (const Part& inner : part.parts) {
            if (!inner.usable || !inner.is(Role::Controller)) continue;
            ParamScope own(&scope);
            own.declare(inner.params);
            const Record record = m_context.read(inner, own, nullptr, Origin::Instance);
            const bool known = !config || m_context.checkReferences(record, *config);
            if (record.complete && known) return componentFrom(record, inner);
        }
        return std::nullopt;
    }

    double memberCount(const Part& part, const Record& record) {
        if (!part.is(Role::Layout)) return 1;
        double count = 1;
        if (const ResolvedValue* value = record.find("Count"))
            for (double n : value->value.numbers) count *= n;
        return count;
    }

    void addRobots(const Part& part) {
        m_instance = &part;
        ParamScope scope(&m_context.globals);
        scope.declare(part.params);
        m_context.evaluator.checkAll(scope);
        InstanceValues given;
        const Part* config = nullptr;
        const Record record = readInstance(part, scope, given, config, "RobotConfig");
        const std::optional<ComponentSpec> brain = controller(part, scope, config);
        const Kind* kind = brain ? m_context.registry.find(brain->kind) : nullptr;
        const std::vector<SignalDescription> published = kind ? kind->signals : std::vector<SignalDescription>();
        if (!config || !record.complete) return;
        const double members = memberCount(part, record);
        if (!roomFor(part, *config, members, record.rangeOf("Count", part.nameRange()))) return;
        const std::shared_ptr<const RobotConfigSpec> spec = robotConfig(*config, given);
        if (spec->bodies.empty()) return; // reported
        if (!part.is(Role::Layout)) {
            const RobotFields f = fieldsFrom<RobotFields>(record);
            m_context.out.robots.push_back(
                {part.name, poseOf(f.pos, f.hpr), spec, brain, part.range, part.nameRange(), published});
            return;
        }
        const std::vector<Pose> poses =
            part.kind->name == "Grid" ? gridPoses(m_context, part, record) : scatterPoses(m_context, part, record, *spec);
        for (std::size_t i = 0; i < poses.size(); ++i) {
            std::string name = part.name + "_" + std::to_string(i);
            if (const Part* other = m_context.outline.world.find(name)) {
                Diagnostic& d = m_context.diagnostics.error(Code::DuplicateName, other->nameRange(),
                                                            "the name " + name + " belongs to a member of " + part.title());
                d.notes.push_back({"defined here", part.nameRange()});
                continue;
            }
            m_context.out.robots.push_back({std::move(name), poses[i], spec, brain, part.range, part.nameRange(), published});
        }
    }

    ResolveContext& m_context;
    std::map<std::string, std::shared_ptr<const RobotConfigSpec>> m_robots;
    std::map<std::string, std::shared_ptr<const std::vector<GeomSpec>>> m_statics;
    std::map<const Part*, std::size_t> m_sizes;
    const Part* m_instance = nullptr;                   ///< whose config is being resolved
    const InstanceVariants::Params* m_params = nullptr; ///< values from outside; null: none
    double m_objects = 0;
    bool m_tooMany = false;
};

} // namespace

void resolveInstances(ResolveContext& context) { Instances(context).run(); }

InstanceVariants::Params InstanceVariants::params() const {
    Diagnostics silent;
    ExperimentSpec nothing;
    ResolveContext context(*m_outline, m_assets, silent, nothing);
    return Instances(context).paramsOf(*m_instance);
}

std::optional<std::vector<ConfigGeom>> InstanceVariants::geoms(const Params& changed) const {
    Diagnostics silent;
    ExperimentSpec out;
    ResolveContext context(*m_outline, m_assets, silent, out);
    Instances(context).only(*m_instance, changed);
    std::vector<ConfigGeom> all;
    if (!out.robots.empty() && out.robots[0].config) { // all members of a Grid or Scatter have one config
        for (const BodySpec& body : out.robots[0].config->bodies)
            for (const GeomSpec& geom : body.geoms) all.push_back({geom, body.pose});
    } else if (out.statics.size() == 1 && out.statics[0].geoms) {
        for (const GeomSpec& geom : *out.statics[0].geoms) all.push_back({geom, Pose{}});
    } else {
        return std::nullopt;
    }
    return all;
}

} // namespace trundle
