#include "world/robot_signals.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

#include "base/platform/work_team.h"
#include "model/signal_count.h"
#include "world/signal_plan.h"

namespace trundle {

namespace {

constexpr std::size_t kPublishedByThread = 32; // fewer are done before another thread has begun

double* put(double* to, const Vec3& v) {
    to[0] = v.x();
    to[1] = v.y();
    to[2] = v.z();
    return to + 3;
}

double* put(double* to, const Vec3& position, const Quat& q) {
    to = put(to, position);
    to[0] = q.w();
    to[1] = q.x();
    to[2] = q.y();
    to[3] = q.z();
    return to + 4;
}

double* putJoint(double* to, JointHandle joint, const WorldObjects& objects, const Engine& engine) {
    if (!objects.jointHasPosition(joint.index)) return to;
    const JointReading& reading = engine.jointReading(joint);
    *to++ = reading.position;
    *to++ = reading.rate;
    if (!objects.jointHasTwo(joint.index)) return to;
    *to++ = reading.position2;
    *to++ = reading.rate2;
    return to;
}

double* putSpring(double* to, const CouplingState& state) {
    *to++ = state.length;
    *to++ = state.rate;
    *to++ = state.effort;
    return to;
}

/// Same order as planRobot().
void publishRobot(const BuiltRobot& robot, const WorldObjects& objects, const Engine& engine, std::uint64_t ticks, double* to) {
    const BodyState& first = engine.state(robot.handles.bodies[0]);
    const Pose frame = WorldObjects::reportedPose(robot, engine, ticks);
    to = put(to, frame.position, frame.rotation);
    to = put(to, first.linear + first.angular.cross(frame.position - first.position));
    to = put(to, first.angular);
    for (const BodyHandle body : robot.handles.bodies) {
        const BodyState& s = engine.state(body);
        to = put(to, s.position, s.rotation);
        to = put(to, s.linear);
        to = put(to, s.angular);
    }
    for (const JointHandle joint : robot.handles.joints) to = putJoint(to, joint, objects, engine);
    const std::size_t springs = robot.spec->config->springs.size();
    for (std::size_t i = 0; i < robot.handles.couplings.size(); ++i) {
        const CouplingState state = engine.coupling(robot.handles.couplings[i]);
        if (i < springs) to = putSpring(to, state);
        else *to++ = state.effort;
    }
}

/// Controllers of two robots of one config.
bool publishTheSame(const RobotSpec& a, const RobotSpec& b) {
    return std::ranges::equal(a.controllers, b.controllers, [](const ControllerSpec& x, const ControllerSpec& y) {
        if (x.published.empty() && y.published.empty()) return true;
        return x.name == y.name && std::ranges::equal(x.published, y.published, [&](const auto& s, const auto& t) {
                   return s.name == t.name && s.unit == t.unit && s.type == t.type && s.direction == t.direction &&
                          signalCount(s, x) == signalCount(t, y);
               });
    });
}

} // namespace

SignalLayout RobotSignals::layOut(const ExperimentSpec& experiment, const WorldObjects& objects, WorldDevices& devices) {
    SignalLayout layout;
    m_images.clear();
    std::unordered_map<const RobotConfigSpec*, std::uint32_t> latest; // robot with a config
    for (const BuiltRobot& robot : objects.robots()) {
        const auto index = static_cast<std::uint32_t>(m_images.size());
        const auto [place, isFirst] = latest.try_emplace(robot.spec->config.get(), index);
        const std::uint32_t equal = std::exchange(place->second, index);
        if (!isFirst && publishTheSame(*objects.robots()[equal].spec, *robot.spec)) {
            m_images.push_back(layout.slotCount());
            layout.repeatRobot(robot.spec->name, equal);
            devices.layOutLike(index, equal, m_images[index] - m_images[equal]);
            continue;
        }
        m_images.push_back(planRobot(layout, *robot.spec));
        devices.layOut(index, *robot.spec->config, layout);
        planControllers(layout, *robot.spec);
    }
    m_between = planBetweenRobots(layout, experiment);
    return layout;
}

void RobotSignals::publish(const WorldObjects& objects, Engine& engine, const WorldRegions& regions, std::uint64_t ticks,
                           SignalBlock& block) const {
    const auto part = [&](unsigned, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            publishRobot(objects.robots()[i], objects, engine, ticks, block.slots().data() + m_images[i]);
    };
    if (WorkTeam* team = engine.threads(false)) team->split(m_images.size(), kPublishedByThread, part);
    else part(0, 0, m_images.size());
    double* to = block.slots().data() + m_between;
    for (const JointHandle joint : objects.joints()) to = putJoint(to, joint, objects, engine);
    for (const CouplingHandle spring : objects.springs()) to = putSpring(to, engine.coupling(spring));
    regions.write(to);
}

} // namespace trundle
