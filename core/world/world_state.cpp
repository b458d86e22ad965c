// Reading a world's state, external commands to it, and its end in a fault.
#include <algorithm>
#include <bit>
#include <cstdio>

#include "schema/live_value.h"
#include "world/built_world.h"
#include "world/validate.h"
#include "world/world_fault.h"

namespace trundle {

namespace {

/// FNV-1a hash of doubles as little-endian bytes.
class StateHash {
public:
    void add(double value) {
        const auto bits = std::bit_cast<std::uint64_t>(value);
        for (int i = 0; i < 8; ++i) {
            m_hash ^= (bits >> (8 * i)) & 0xff;
            m_hash *= 0x100000001b3ull;
        }
    }
    void add(const Vec3& v) {
        for (int k = 0; k < 3; ++k) add(v[k]);
    }
    [[nodiscard]] std::uint64_t value() const { return m_hash; }

private:
    std::uint64_t m_hash = 0xcbf29ce484222325ull;
};

Status checkAlive(const World& world, std::size_t robot) {
    if (!hasEnded(world, robot)) return {};
    const std::string& name = world.experiment().robots[robot].name;
    return Error{Code::OutOfRange, name + " has ended and stays where it is until the run starts again"};
}

} // namespace

/// In the order in which they are built: moving scenery and robots by their names, the bodies of one as its config has them, so that the
/// names of these do not matter.
std::uint64_t BuiltWorld::stateHash() const {
    StateHash hash;
    for (std::uint32_t body = 0; body < m_objects.bodyPaths().size(); ++body) {
        const BodyState& s = m_engine->state({body});
        hash.add(s.position);
        hash.add(s.rotation.w());
        hash.add(Vec3(s.rotation.vec()));
        hash.add(s.linear);
        hash.add(s.angular);
    }
    return hash.value();
}

Pose BuiltWorld::robotPose(std::size_t robot) const {
    return robot < m_objects.robots().size() ? framePose(m_objects.robots()[robot]) : Pose{};
}

Pose BuiltWorld::reportedPose(std::size_t robot) const {
    if (robot >= m_objects.robots().size()) return {};
    return WorldObjects::reportedPose(m_objects.robots()[robot], *m_engine, m_ticks);
}

Pose BuiltWorld::framePose(const BuiltRobot& robot) const { return WorldObjects::framePose(robot, *m_engine, m_ticks); }

RobotEnergy BuiltWorld::robotEnergy(std::size_t index) const {
    RobotEnergy energy;
    if (index >= m_objects.robots().size()) return energy;
    const BuiltRobot& robot = m_objects.robots()[index];
    for (std::size_t b = 0; b < robot.handles.bodies.size(); ++b) {
        const MassProperties& m = robot.spec->config->bodies[b].mass;
        const BodyState& s = m_engine->state(robot.handles.bodies[b]);
        const Vec3 lever = s.rotation * m.centre, v = s.linear + s.angular.cross(lever), w = s.rotation.conjugate() * s.angular;
        energy.kinetic += 0.5 * m.mass * v.squaredNorm() + 0.5 * w.dot(m.inertia * w);
        energy.potential -= m.mass * m_experiment->settings.gravity.dot(s.position + lever);
    }
    return energy;
}

const std::vector<WorldContact>& BuiltWorld::contacts() const {
    if (m_contactsReady) return m_contacts;
    m_contacts.clear();
    for (std::size_t i = 0; i < m_engine->contactCount(); ++i) {
        const EngineContact c = m_engine->contact(i);
        m_contacts.push_back(
            {m_objects.geomPath(c.first), m_objects.geomPath(c.second), c.position, c.normal, c.depth, c.force, c.friction});
    }
    m_contactsReady = true;
    return m_contacts;
}

SweepReport BuiltWorld::sweeps() const {
    SweepReport report{m_engine->sweeps().bodies, {}};
    for (const auto& [first, second] : m_engine->sweeps().passages)
        report.passed.emplace_back(m_objects.geomPath(first), m_objects.geomPath(second));
    return report;
}

Status checkPush(const World& world, std::size_t robot, const Vec3& force, const Vec3& point) {
    if (!force.allFinite() || !point.allFinite() || force.norm() > 1e9)
        return Error{Code::OutOfRange, "a push needs a finite force of at most 1e9 N"};
    return checkAlive(world, robot);
}

Status checkPlace(const World& world, const JoinedRobots& joined, std::size_t index, const Pose& pose) {
    const RobotSpec& robot = world.experiment().robots[index];
    if (robot.scenery) return Error{Code::OutOfRange, robot.name + " is scenery, which has its place in the text alone"};
    if (!isPosition(pose)) return Error{Code::OutOfRange, "a robot's position must be finite and within 100 km"};
    if (const Status alive = checkAlive(world, index); !alive) return alive;
    const std::string& hold = joined.hold(index);
    return hold.empty() ? Status() : Error{Code::OutOfRange, robot.name + " cannot be placed: " + hold};
}

Status BuiltWorld::push(const std::string& body, const Vec3& force, const Vec3& point) {
    const std::uint32_t* index = m_objects.findBody(body);
    if (!index) return Error{Code::UnknownReference, "there is no body " + body};
    const auto robot = static_cast<std::size_t>(m_objects.findRobot(body.substr(0, body.find('/'))) - m_objects.robots().data());
    if (hasEnded(*this, robot)) return {}; // the user may still pull at it, with a command in each tick
    if (const Status possible = checkPush(*this, robot, force, point); !possible) return possible;
    if (!m_objects.isFixed(*index)) m_engine->addForce({*index}, force, point);
    return {};
}

Status BuiltWorld::place(const std::string& name, const Pose& pose) {
    const BuiltRobot* robot = m_objects.findRobot(name);
    if (!robot) return Error{Code::UnknownReference, "there is no robot " + name};
    const auto index = static_cast<std::size_t>(robot - m_objects.robots().data());
    if (const Status possible = checkPlace(*this, m_joined, index, pose); !possible) return possible;
    const Pose motion = pose * framePose(*robot).inverse();
    for (const std::size_t joined : m_joined.with(index)) m_placed[joined] = motion; // a train stays one
    return {};
}

Status BuiltWorld::setSurface(const SurfaceSpec& surface) {
    if (!isSurface(surface)) return Error{Code::OutOfRange, "the surface " + surface.name + " cannot have these values"};
    const std::vector<SurfaceSpec>& surfaces = m_experiment->surfaces;
    const auto first = std::ranges::find(surfaces, surface.name, &SurfaceSpec::name);
    if (first == surfaces.end()) return Error{Code::UnknownReference, "there is no surface " + surface.name};
    for (auto s = first; s != surfaces.end(); ++s) {
        if (s->name != surface.name) continue;
        SurfaceSpec values = surface;
        if (s != first) values.frictionHeading = -values.frictionHeading; // that of mirrored parts
        m_engine->setSurface(static_cast<std::size_t>(s - surfaces.begin()), values);
    }
    return {};
}

Status BuiltWorld::setProperty(const std::string& path, const std::string& property, const PropertyValue& value) {
    const WorldDevice* device = m_devices.list().find(path);
    if (!device) return Error{Code::UnknownReference, "there is no device " + path};
    const MonitoredCall call(*m_calls, device->target, "set");
    return setLive(*device->kind, device->instance, path, property, value);
}

Status BuiltWorld::stopAt(const EngineFault& fault) {
    const double tick = m_experiment->settings.tick, end = static_cast<double>(m_ticks + 1) * tick;
    return stop(fault.body.valid() ? Code::BlowUp : Code::EngineFault, faultFrom(fault, m_objects, *m_engine, tick, end));
}

Status BuiltWorld::stopAt(const WorldDevice& failed) {
    return stop(Code::DeviceSetup, {"", time(), failed.path + ": " + failed.failure, failed.spec->nameRange});
}

Status BuiltWorld::stop(Code code, Fault fault) {
    m_fault = std::move(fault);
    m_faultCode = code;
    return stopped();
}

Status BuiltWorld::stopped() const {
    char time[32];
    std::snprintf(time, sizeof time, "%.6g", m_fault->time);
    const std::string who = m_fault->body.empty() ? "the simulation" : m_fault->body;
    return Error{m_faultCode, who + " stopped at t = " + time + " s: " + m_fault->reason};
}

} // namespace trundle
