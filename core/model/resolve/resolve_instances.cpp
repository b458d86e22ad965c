// Resolves Robots, Statics, Grids and Scatters: config, values, poses and controllers. Instances with equal values share one
// resolved config.
#include <algorithm>
#include <iterator>

#include "base/spelling.h"
#include "model/kinds/world_fields.h"
#include "model/provenance.h"
#include "model/repeat.h"
#include "model/resolve/config_sizes.h"
#include "model/resolve/instance_variants.h"
#include "model/resolve/part_messages.h"
#include "model/resolve/reference_check.h"
#include "model/resolve/resolve_steps.h"
#include "model/resolve/scatter_places.h"
#include "schema/value_reader.h"
#include "schema/value_words.h"

namespace trundle {

namespace {

double objectsOf(const RobotConfigSpec& config) {
    std::size_t objects =
        config.bodies.size() + config.joints.size() + config.springs.size() + config.gears.size() + config.devices.size();
    for (const BodySpec& body : config.bodies) objects += body.geoms.size();
    return static_cast<double>(objects);
}

class Instances {
public:
    explicit Instances(ResolveContext& context) : m_context(context) {}

    void run(PartExpansion& world) {
        checkConfigs();
        m_tooMany = m_tooMany || world.hasTooMany();
        const auto isKind = [](const ExpandedPart& part, const char* kind) { return part.part->kind->name == kind; };
        world.each(Role::Instance, [&](const ExpandedPart& part) {
            if (isKind(part, "Static")) addStatics(part);
        });
        world.each(Role::Layout, [&](const ExpandedPart& part) {
            if (isScenery(*part.part)) addStatics(part);
        });
        world.each(Role::Instance, Role::Layout, [&](const ExpandedPart& part) {
            if (!isKind(part, "Static") && !isScenery(*part.part)) addRobots(part);
        });
        for (const bool scenery : {true, false})
            world.each(Role::Layout, [&](const ExpandedPart& part) {
                if (isScenery(*part.part) == scenery) m_scatters.place(part);
            });
        m_scatters.removeLeftOut();
        addMovingScenery();
    }

    /// Resolves one Robot, Static, Grid or Scatter only, with these Params instead of its own.
    void only(const Part& part, const InstanceVariants::Params& params) {
        m_params = &params;
        const PartExpansion world(m_context);
        const auto it = std::ranges::find(world.parts(), &part, &ExpandedPart::part);
        if (it == world.parts().end()) return;
        if (part.kind->name == "Static" || isScenery(part)) addStatics(*it);
        else addRobots(*it);
        m_scatters.place(*it);
        m_scatters.removeLeftOut();
        addMovingScenery();
    }

    InstanceVariants::Params paramsOf(const Part& part) {
        ParamScope scope(&m_context.globals), inner(&m_context.globals);
        scope.declare(part.params);
        InstanceValues given;
        const Part* config = nullptr;
        (void)read(part, scope, given, config, part.kind->name == "Static" || isScenery(part) ? "StaticConfig" : "RobotConfig");
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
    /// Resolves every config with its own values, so that errors in unused ones are reported too; PartConfigs last, since what is
    /// wrong in one is reported with the first use.
    void checkConfigs() {
        reportPartCircles(m_context);
        double objects = 0;
        for (const Part* part : m_context.outline.configs.all()) {
            if (part->kind->name == "PartConfig") continue;
            objects += m_sizes.of(*part);
            if (objects > static_cast<double>(kMaxObjects)) {
                Diagnostic& d =
                    m_context.diagnostics.error(Code::TooManyObjects, part->nameRange(),
                                                "with " + part->title() + " there would be configs of more than 200000 objects");
                noteCount(d, m_sizes.largestRepeat());
                m_tooMany = true;
                break;
            }
            if (part->kind->name == "RobotConfig") (void)robotConfig(*part, InstanceValues{});
            else (void)staticConfig(*part, InstanceValues{});
        }
        for (const Part* part : m_context.outline.configs.all())
            if (part->kind->name == "PartConfig") checkPartConfig(m_context, *part);
    }

    Record read(const Part& part, ParamScope& scope, InstanceValues& given, const Part*& config, std::string_view kind,
                std::size_t member = 0) {
        Record record = readInstance(m_context, part, scope, given, config, kind, nullptr, member);
        for (const auto& [name, value] : config&& m_params ? *m_params : InstanceVariants::Params{}) given.addParam(name, value);
        return record;
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
        const Part* instance = given.key.empty() ? nullptr : m_instance;
        nameInstance(m_context, said, given, instance, instance ? "with the values of " + instance->title() : std::string());
        return spec;
    }
    std::shared_ptr<const RobotConfigSpec> robotConfig(const Part& config, const InstanceValues& given) {
        return shared(m_robots, config, given, resolveRobotConfig);
    }
    std::shared_ptr<const StaticConfigSpec> staticConfig(const Part& config, const InstanceValues& given) {
        return shared(m_statics, config, given, resolveStaticConfig);
    }

    /// Checks the object count before anything is built; false, with a diagnostic, if there would be too many.
    bool roomFor(const Part& part, double objects, SourceRange place) {
        m_objects += objects;
        if (m_objects <= static_cast<double>(kMaxObjects) && !m_tooMany) return true;
        const auto isSaid = [](const Diagnostic& d) { return d.code == Code::TooManyObjects; };
        if (!m_tooMany && std::ranges::none_of(m_context.diagnostics.all(), isSaid)) {
            m_context.diagnostics.error(Code::TooManyObjects, place,
                                        "with " + part.title() + " the world would hold more than 200000 objects");
        }
        m_tooMany = true;
        return false;
    }

    /// What a Robot or Static, or one member of a Grid or Scatter, is made of.
    struct Described {
        Record record;
        InstanceValues given;
        const Part* config = nullptr;
        std::vector<ControllerSpec> brains;
        bool isNumbered = false; ///< other members differ: their number is used
        std::shared_ptr<const RobotConfigSpec> spec;
        std::shared_ptr<const StaticConfigSpec> scenery; ///< of a Static
    };

    /// Whether the members of a Grid or Scatter are scenery.
    bool isScenery(const Part& part) const {
        const Part* config = part.is(Role::Layout) ? configOf(m_context.outline, part) : nullptr;
        return config && config->kind->name == "StaticConfig";
    }

    /// A Static, or the members of a Grid or Scatter of scenery.
    void addStatics(const ExpandedPart& expanded) {
        const Part& part = *expanded.part;
        m_instance = &part;
        const std::size_t first = m_context.diagnostics.all().size();
        std::vector<Described> all{describe(expanded, 0, "StaticConfig")};
        if (!all[0].config || !all[0].record.complete) return;
        const std::size_t members = membersOf(part, all[0].record);
        const SourceRange place = all[0].record.rangeOf("Count", part.nameRange());
        if (!roomFor(part, static_cast<double>(members) * m_sizes.of(*all[0].config), place)) return;
        if (!resolveScenery(part, all[0])) return;
        const auto resolve = [&](Described& d) { return resolveScenery(part, d); };
        if (!describeOthers(expanded, "StaticConfig", first, members, resolve, all)) return;
        const std::vector<Pose> poses = posesOf(expanded, all);
        for (std::size_t i = 0; i < poses.size(); ++i) {
            const Described& d = all[std::min(i, all.size() - 1)];
            const std::string name = memberName(expanded, i);
            if (!isFree(part, name)) continue;
            const Pose pose = expanded.placed(poses[i]);
            const std::shared_ptr<const std::vector<GeomSpec>> geoms(d.scenery, &d.scenery->geoms);
            m_context.out.statics.push_back({name, d.config->name, pose, geoms, part.range, part.nameRange()});
            // What moves, senses or acts in a Static is to everything else a robot with a fixed frame.
            if (d.scenery->moving) m_moving.push_back(robot(part, name, pose, d.scenery->moving, d.brains, geoms));
            m_scatters.addStatic(expanded, i, d.scenery->moving != nullptr);
        }
    }

    /// False if there would be too many objects.
    bool resolveScenery(const Part& part, Described& d) {
        d.scenery = staticConfig(*d.config, d.given);
        if (!d.scenery->moving && !d.brains.empty())
            m_context.diagnostics.error(Code::WrongPlace, d.brains.front().nameRange,
                                        part.title() + " has a controller, but " + d.config->title() + " has no devices");
        const double moving = d.scenery->moving ? objectsOf(*d.scenery->moving) : 0;
        const double more = static_cast<double>(d.scenery->geoms.size()) + moving - m_sizes.of(*d.config);
        return more <= 0 || roomFor(part, more, part.nameRange());
    }

    static std::size_t membersOf(const Part& part, const Record& record) {
        return part.is(Role::Layout) ? memberCount(record.find("Count")->value.numbers) : 1;
    }
    static std::string memberName(const ExpandedPart& expanded, std::size_t member) {
        return expanded.name() + (expanded.part->is(Role::Layout) ? "_" + std::to_string(member) : std::string());
    }
    /// False, with a diagnostic, if something else has the name of a member.
    bool isFree(const Part& part, const std::string& name) const {
        const Part* other = part.is(Role::Layout) ? m_context.outline.world.find(name) : nullptr;
        if (!other || other == &part) return true;
        Diagnostic& e = m_context.diagnostics.error(Code::DuplicateName, other->nameRange(),
                                                    "the name " + name + " belongs to a member of " + part.title());
        e.notes.push_back({"defined here", part.nameRange()});
        return false;
    }

    void addMovingScenery() { std::ranges::move(m_moving, std::back_inserter(m_context.out.robots)); }

    RobotSpec robot(const Part& part, const std::string& name, const Pose& pose, std::shared_ptr<const RobotConfigSpec> config,
                    std::vector<ControllerSpec> brains, std::shared_ptr<const std::vector<GeomSpec>> scenery = nullptr) const {
        return {name, pose, std::move(config), std::move(brains), part.range, part.nameRange(), std::move(scenery)};
    }

    /// False, with a diagnostic, if the config has something with that name: their signals would have the same paths.
    bool isFreeBeside(const Part& controller, const Part* config) const {
        const Part* taken = config ? config->find(controller.name) : nullptr;
        if (!taken) return true;
        Diagnostic& e = m_context.diagnostics.error(Code::DuplicateName, controller.nameRange(),
                                                    "the name " + controller.name + " is taken by " + taken->title() + " of " +
                                                        config->title());
        e.notes.push_back({"defined here", taken->nameRange()});
        return false;
    }

    std::vector<ControllerSpec> controllers(const Part& part, ParamScope& scope, const Part* config) {
        std::vector<ControllerSpec> all;
        for (const Part& inner : part.parts) {
            if (!inner.usable || !inner.is(Role::Controller) || !isFreeBeside(inner, config)) continue;
            ParamScope own(&scope);
            own.declare(inner.params);
            Record record = m_context.read(inner, own, nullptr, Origin::Instance);
            const bool known = !config || checkReferences(m_context, record, *config);
            if (!record.complete || !known) continue;
            const Kind* kind = m_context.registry.find(inner.kind->name);
            all.push_back({componentFrom(record, inner), kind ? kind->signals : std::vector<SignalDescription>()});
        }
        return all;
    }

    Described describe(const ExpandedPart& expanded, std::size_t member, std::string_view kind) {
        const Part& part = *expanded.part;
        Described d;
        ParamScope scope(expanded.frame->scope);
        scope.declare(part.params);
        m_context.evaluator.checkAll(scope);
        d.record = read(part, scope, d.given, d.config, kind, member);
        d.brains = controllers(part, scope, d.config);
        d.isNumbered = isIndexUsed(scope);
        return d;
    }

    /// Adds the other members if their numbers matter, up to the first with an error: the others, which would repeat it, are shown
    /// as that one. `first`: index of the first diagnostic of the layout. False if one cannot be resolved.
    template <class Resolve>
    bool describeOthers(const ExpandedPart& expanded, std::string_view kind, std::size_t first, std::size_t members,
                        const Resolve& resolve, std::vector<Described>& all) {
        const Part& part = *expanded.part;
        const auto hasError = [&] {
            const std::vector<Diagnostic>& said = m_context.diagnostics.all();
            return std::any_of(said.begin() + static_cast<std::ptrdiff_t>(first), said.end(),
                               [](const Diagnostic& d) { return d.severity == Severity::Error; });
        };
        for (std::size_t k = first; all[0].isNumbered && k < m_context.diagnostics.all().size(); ++k)
            nameMember(m_context, m_context.diagnostics.at(k), part, 0);
        for (std::size_t i = 1; all[0].isNumbered && i < members && !hasError(); ++i) {
            const std::size_t before = m_context.diagnostics.all().size();
            all.push_back(describe(expanded, i, kind));
            const bool isGood = all[i].config && resolve(all[i]);
            for (std::size_t k = before; k < m_context.diagnostics.all().size(); ++k)
                nameMember(m_context, m_context.diagnostics.at(k), part, i);
            if (!isGood) return false;
        }
        return true;
    }

    /// False if there would be too many objects, or the robot has no body.
    bool resolveMember(const Part& part, Described& d) {
        d.spec = robotConfig(*d.config, d.given);
        const double more = objectsOf(*d.spec) - m_sizes.of(*d.config); // Repeats may have more members than by default
        return !d.spec->bodies.empty() && (more <= 0 || roomFor(part, more, part.nameRange()));
    }

    void addRobots(const ExpandedPart& expanded) {
        const Part& part = *expanded.part;
        m_instance = &part;
        m_context.failedRobots.insert(&part); // until it is there
        const std::size_t first = m_context.diagnostics.all().size();
        std::vector<Described> all{describe(expanded, 0, "RobotConfig")};
        if (!all[0].config || !all[0].record.complete) return;
        const std::size_t members = membersOf(part, all[0].record);
        const SourceRange place = all[0].record.rangeOf("Count", part.nameRange());
        if (!roomFor(part, static_cast<double>(members) * m_sizes.of(*all[0].config), place)) return;
        if (!resolveMember(part, all[0])) return; // reported
        const auto resolve = [&](Described& d) { return resolveMember(part, d); };
        if (!describeOthers(expanded, "RobotConfig", first, members, resolve, all)) return;
        const std::vector<Pose> poses = posesOf(expanded, all);
        for (std::size_t i = 0; i < poses.size(); ++i) {
            const Described& d = all[std::min(i, all.size() - 1)];
            const std::string name = memberName(expanded, i);
            if (!isFree(part, name)) continue;
            m_context.out.robots.push_back(robot(part, name, expanded.placed(poses[i]), d.spec, d.brains));
            m_scatters.addRobot(expanded, i);
            m_context.failedRobots.erase(&part);
        }
    }

    std::vector<Pose> posesOf(const ExpandedPart& expanded, const std::vector<Described>& all) {
        const Part& part = *expanded.part;
        const Record& record = all[0].record;
        if (part.kind->name == "Grid") return gridPoses(m_context, part, record);
        if (!part.is(Role::Layout)) {
            const RobotFields f = fieldsFrom<RobotFields>(record);
            return {poseOf(f.pos, f.hpr)};
        }
        RobotDisc largest;
        for (const Described& d : all) {
            const RobotDisc disc = d.scenery ? discOf(d.scenery->geoms, d.scenery->moving.get()) : discOf(*d.spec);
            if (&d == &all[0] || disc.radius > largest.radius) largest = disc;
        }
        m_scatters.add(expanded, record, largest);
        return std::vector<Pose>(membersOf(part, record)); // for now
    }

    ResolveContext& m_context;
    std::map<std::string, std::shared_ptr<const RobotConfigSpec>> m_robots;
    std::map<std::string, std::shared_ptr<const StaticConfigSpec>> m_statics;
    std::vector<RobotSpec> m_moving; ///< of Statics, which come after all robots
    ScatterPlaces m_scatters{m_context, m_moving};
    ConfigSizes m_sizes{m_context};
    const Part* m_instance = nullptr;                   ///< whose config is being resolved
    const InstanceVariants::Params* m_params = nullptr; ///< values from outside; null: none
    double m_objects = 0;
    bool m_tooMany = false;
};

} // namespace

void resolveInstances(ResolveContext& context, PartExpansion& world) { Instances(context).run(world); }

InstanceVariants::Params InstanceVariants::params() const {
    Diagnostics silent;
    ExperimentSpec nothing;
    ResolveContext context(*m_outline, m_assets, silent, nothing);
    return Instances(context).paramsOf(*m_instance);
}

std::optional<std::vector<ConfigGeom>> InstanceVariants::geoms(const Params& changed) const {
    Diagnostics silent;
    ExperimentSpec out;
    out.materials.emplace_back(); // the looks, and so the surfaces, are left out: all geoms have the default
    out.surfaces.emplace_back();
    ResolveContext context(*m_outline, m_assets, silent, out);
    Instances(context).only(*m_instance, changed);
    std::vector<ConfigGeom> all;
    const bool hasBodies = !out.robots.empty() && out.robots[0].config, isStatic = !out.statics.empty() && out.statics[0].geoms;
    if (!hasBodies && !isStatic) return std::nullopt;
    for (const GeomSpec& geom : isStatic ? *out.statics[0].geoms : std::vector<GeomSpec>()) all.push_back({geom, Pose{}});
    if (hasBodies) // all members of a Grid or Scatter have one config
        for (const BodySpec& body : out.robots[0].config->bodies)
            for (const GeomSpec& geom : body.geoms) all.push_back({geom, body.pose});
    return all;
}

} // namespace trundle
