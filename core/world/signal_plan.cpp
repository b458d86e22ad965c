#include "world/signal_plan.h"

#include <algorithm>

#include <trundle/describe.h>
#include <trundle/device_signals.h>

namespace trundle {

namespace {

constexpr auto kReal = SignalType::Real;
constexpr auto kTruth = SignalDirection::Truth;

/// Pose and velocity of a robot or of one of its bodies; returns the first slot.
std::uint32_t addState(SignalLayout& layout, const std::string& path) {
    const auto first = layout.slotCount();
    for (const SignalInfo& s : descriptionOf<GroundTruthSignals>().signals())
        layout.add(path + "/" + s.name, s.unit, kReal, kTruth, s.count);
    return first;
}

} // namespace

std::uint32_t planRobot(SignalLayout& layout, const RobotSpec& robot) {
    const std::string& name = robot.name;
    layout.beginRobot(name);
    const std::uint32_t first = addState(layout, name);
    for (const BodySpec& body : robot.config->bodies) addState(layout, name + "/" + body.name);
    for (const JointSpec& joint : robot.config->joints) {
        if (!hasPosition(joint.type)) continue;
        const bool linear = joint.type == JointType::Slider;
        layout.add(name + "/" + joint.name + "/position", linear ? "m" : "rad", kReal, kTruth);
        layout.add(name + "/" + joint.name + "/rate", linear ? "m/s" : "rad/s", kReal, kTruth);
    }
    return first;
}

void planController(SignalLayout& layout, const RobotSpec& robot) {
    if (!robot.controller) return;
    for (const SignalDescription& s : robot.published)
        if (s.direction == TRUNDLE_OUTPUT)
            layout.add(robot.name + "/" + robot.controller->name + "/" + s.name, s.unit, static_cast<SignalType>(s.type),
                       SignalDirection::Output, std::max(s.count, 1u));
}

SignalLayout plannedLayout(const ExperimentSpec& experiment, const Registry& registry) {
    SignalLayout layout;
    for (const RobotSpec& robot : experiment.robots) {
        planRobot(layout, robot);
        for (const ComponentSpec& device : robot.config->devices) {
            const Kind* kind = registry.find(device.kind);
            if (!kind) continue;
            for (const SignalDescription& s : kind->signals)
                layout.add(robot.name + "/" + device.name + "/" + s.name, s.unit, static_cast<SignalType>(s.type),
                           static_cast<SignalDirection>(s.direction), std::max(s.count, 1u));
        }
        planController(layout, robot);
    }
    return layout;
}

} // namespace trundle
