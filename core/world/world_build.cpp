#include <algorithm>
#include <numeric>

#include "base/rng.h"
#include "model/passive_objects.h"
#include "world/built_world.h"
#include "world/signal_plan.h"
#include "world/validate.h"

namespace trundle {

namespace {

template <class List> std::vector<std::size_t> byName(const List& list) {
    std::vector<std::size_t> order(list.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return list[a].name < list[b].name; });
    return order;
}

} // namespace

std::unique_ptr<World> World::build(std::shared_ptr<const ExperimentSpec> experiment, const DeviceCode& devices,
                                    Diagnostics& diagnostics, std::shared_ptr<CallMonitor> calls) {
    if (!calls) calls = std::make_shared<CallMonitor>();
    auto world = std::make_unique<BuiltWorld>(std::move(experiment), std::move(calls));
    if (!world->build(devices, diagnostics)) return nullptr;
    return world;
}

BuiltWorld::BuiltWorld(std::shared_ptr<const ExperimentSpec> experiment, std::shared_ptr<CallMonitor> calls)
    : m_experiment(std::move(experiment)), m_calls(std::move(calls)), m_solver(m_calls->add({"the solver", {}, {}, {}})) {}

BuiltWorld::~BuiltWorld() = default;

bool BuiltWorld::build(const DeviceCode& devices, Diagnostics& diagnostics) {
    const std::size_t before = diagnostics.errorCount();
    const auto failed = [&] { return diagnostics.errorCount() > before; };
    if (!isBuildable(*m_experiment, diagnostics)) return false;
    const SettingsSpec& s = m_experiment->settings;
    auto engine =
        makeOdeEngine({s.gravity, s.seed, s.solver, s.iterations, s.errorReduction, m_experiment->surfaces, m_calls.get()});
    if (!engine) {
        diagnostics.error(engine.error().code, {}, engine.error().message);
        return false;
    }
    m_engine = std::move(engine).value();
    buildScenery(diagnostics);
    buildRobots(diagnostics);
    if (failed()) return false;
    nameBodies();
    createDevices(devices, diagnostics);
    if (failed()) return false;
    layOutSignals();
    openMedium();
    m_block = std::make_unique<SignalBlock>(m_layout);
    fillServices(m_services, *this, s.tick);
    setupDevices(diagnostics);
    if (!failed()) orderDevices(diagnostics);
    if (failed()) return false;
    publish();
    placeRadios();
    if (!callDevices(false)) { // so that sensor signals are valid at tick 0
        diagnostics.error(Code::DeviceSetup, m_fault->range, m_fault->reason);
        return false;
    }
    return true;
}

/// Sorted by name, so that the result does not depend on the order of blocks in the text.
void BuiltWorld::buildScenery(Diagnostics& diagnostics) {
    for (const std::size_t i : byName(m_experiment->statics)) {
        const StaticSpec& s = m_experiment->statics[i];
        if (!s.geoms) continue;
        for (const GeomSpec& g : *s.geoms) {
            if (!g.collide) continue;
            const auto id = m_engine->addStatic(g, s.pose * g.pose);
            if (!id) {
                diagnostics.error(id.error().code, g.nameRange, s.name + "/" + id.error().message);
                continue;
            }
            m_geomPaths.resize(std::max<std::size_t>(m_geomPaths.size(), id.value().index + 1));
            m_geomPaths[id.value().index] = s.name + "/" + g.name;
        }
    }
}

void BuiltWorld::buildRobots(Diagnostics& diagnostics) {
    m_robots.resize(m_experiment->robots.size());
    for (const std::size_t i : byName(m_experiment->robots)) {
        const RobotSpec& spec = m_experiment->robots[i];
        BuiltRobot& robot = m_robots[i];
        robot.spec = &spec;
        ActorDef def{spec.pose, {}, &spec.config->joints, spec.config->selfCollision};
        for (const BodySpec& body : spec.config->bodies) def.bodies.push_back({spec.pose * body.pose, &body});
        auto made = m_engine->addActor(def);
        if (!made) {
            diagnostics.error(made.error().code, spec.nameRange, spec.name + "/" + made.error().message);
            continue;
        }
        robot.handles = std::move(made).value();
        const Pose& first = spec.config->bodies[0].pose;
        robot.frameInFirst = first.inverse();
        robot.frameIsFirst = first.position.isZero(0) && first.rotation.coeffs() == Quat::Identity().coeffs();
        if (isPassive(spec)) robot.centre = first * spec.config->bodies[0].mass.centre;
    }
}

void BuiltWorld::nameBodies() {
    for (std::size_t r = 0; r < m_robots.size(); ++r) {
        const BuiltRobot& robot = m_robots[r];
        m_robotByName.emplace(robot.spec->name, static_cast<std::uint32_t>(r));
        const auto& bodies = robot.spec->config->bodies;
        for (std::size_t b = 0; b < bodies.size(); ++b) {
            const std::uint32_t id = robot.handles.bodies[b].index;
            m_bodyPaths.resize(std::max<std::size_t>(m_bodyPaths.size(), id + 1));
            m_bodyRanges.resize(m_bodyPaths.size());
            m_bodyPaths[id] = robot.spec->name + "/" + bodies[b].name;
            m_bodyRanges[id] = bodies[b].nameRange;
            m_bodyByPath.emplace(m_bodyPaths[id], id);
            for (std::size_t g = 0; g < bodies[b].geoms.size(); ++g) {
                const GeomHandle geom = robot.handles.geoms[b][g];
                if (!geom.valid()) continue;
                m_geomPaths.resize(std::max<std::size_t>(m_geomPaths.size(), geom.index + 1));
                m_geomPaths[geom.index] = m_bodyPaths[id] + "/" + bodies[b].geoms[g].name;
            }
        }
        const auto& joints = robot.spec->config->joints;
        for (std::size_t j = 0; j < joints.size(); ++j) {
            const std::uint32_t id = robot.handles.joints[j].index;
            m_jointTurns.resize(std::max<std::size_t>(m_jointTurns.size(), id + 1));
            m_jointTurns[id] = hasPosition(joints[j].type);
            m_jointLocations.resize(m_jointTurns.size());
            m_jointLocations[id] = placeOf(joints[j], robot);
        }
    }
    m_calls->setBodies(m_bodyPaths);
    m_hashOrder.resize(m_bodyPaths.size());
    std::iota(m_hashOrder.begin(), m_hashOrder.end(), 0u);
    std::stable_sort(m_hashOrder.begin(), m_hashOrder.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return m_bodyPaths[a] < m_bodyPaths[b]; });
}

JointLocation BuiltWorld::placeOf(const JointSpec& joint, const BuiltRobot& robot) {
    const Vec3& axis = joint.type == JointType::Suspension ? joint.axis2 : joint.axis; // the axis of rotation
    if (joint.parent == kWorldBody) return {0, false, robot.spec->pose * joint.anchor, robot.spec->pose.rotation * axis};
    const auto parent = static_cast<std::size_t>(joint.parent);
    const Pose inParent = robot.spec->config->bodies[parent].pose.inverse();
    return {robot.handles.bodies[parent].index, true, inParent * joint.anchor, inParent.rotation * axis};
}

/// For each robot: its state signals, contiguous and in the order of publishRobot(), then those of the devices and of the
/// controller.
void BuiltWorld::layOutSignals() {
    for (BuiltRobot& robot : m_robots) {
        robot.image = planRobot(m_layout, *robot.spec);
        for (std::uint32_t d = 0; d < robot.deviceCount; ++d) layOutDevice(*m_devices[robot.firstDevice + d]);
        planController(m_layout, *robot.spec);
    }
}

void BuiltWorld::layOutDevice(Device& device) {
    for (std::uint32_t i = 0; i < device.kind->signalCount; ++i) {
        const TrundleSignal& s = device.kind->signals[i];
        device.slots.push_back(m_layout.add(device.path + "/" + s.name, s.unit ? s.unit : "", static_cast<SignalType>(s.type),
                                            static_cast<SignalDirection>(s.direction), std::max(s.count, 1u)));
    }
}

} // namespace trundle
