#include "world/signal_plan.h"

#include <algorithm>

#include <trundle/describe.h>
#include <trundle/device_signals.h>

namespace trundle {

namespace {

constexpr auto kReal = SignalType::Real;
constexpr auto kTruth = SignalDirection::Truth;

/// Pose and velocity of a robot or of one of its bodies ("body/"); returns the first slot.
std::uint32_t addState(SignalLayout& layout, const std::string& owner) {
    const auto first = layout.slotCount();
    for (const SignalInfo& s : descriptionOf<GroundTruthSignals>().signals())
        layout.add(owner + s.name, s.unit, kReal, kTruth, s.count);
    return first;
}

void addJoint(SignalLayout& layout, const std::string& owner, JointType type) {
    if (!hasPosition(type)) return;
    const bool linear = type == JointType::Slider;
    layout.add(owner + "position", linear ? "m" : "rad", kReal, kTruth);
    layout.add(owner + "rate", linear ? "m/s" : "rad/s", kReal, kTruth);
    if (type != JointType::Universal) return;
    layout.add(owner + "position2", "rad", kReal, kTruth);
    layout.add(owner + "rate2", "rad/s", kReal, kTruth);
}

void addSpring(SignalLayout& layout, const std::string& owner) {
    layout.add(owner + "length", "m", kReal, kTruth);
    layout.add(owner + "rate", "m/s", kReal, kTruth);
    layout.add(owner + "force", "N", kReal, kTruth);
}

std::uint64_t times(std::uint64_t count, double value) {
    if (!(value >= 1)) return count;
    return static_cast<double>(count) * value > 1e15 ? std::uint64_t{1000000000000000}
                                                     : count * static_cast<std::uint64_t>(value);
}

bool isTarget(const ComponentSpec& device, std::string_view signal) {
    return signal == "target" && (device.kind == ServoSignals::kKind || device.kind == LinearMotorSignals::kKind);
}

bool isOnSlider(const RobotConfigSpec& config, const ComponentSpec& device) {
    const std::string joint = device.text("Joint");
    const auto isIt = [&joint](const JointSpec& each) { return each.type == JointType::Slider && each.name == joint; };
    return !joint.empty() && std::any_of(config.joints.begin(), config.joints.end(), isIt);
}

} // namespace

std::uint64_t signalCount(const TrundleKind& kind, const TrundleSignal& signal, const ComponentSpec& device) {
    std::uint64_t count = std::max(signal.count, 1u);
    for (std::uint32_t bits = signal.countFields; bits != 0; bits >>= 16) {
        const std::uint32_t index = bits & 0xffff;
        if (index < 1 || index > kind.fieldCount) continue;
        const TrundleField& field = kind.fields[index - 1];
        const bool hasDefault = field.type == TRUNDLE_INTEGER && field.defaultValue.count == 1;
        count = times(count, device.number(field.name, hasDefault ? field.defaultValue.numbers[0] : 1));
    }
    return count;
}

std::uint32_t planBetweenRobots(SignalLayout& layout, const ExperimentSpec& experiment) {
    const std::uint32_t first = layout.slotCount();
    for (const auto& link : experiment.joints) {
        if (!hasPosition(link.spec.type)) continue;
        layout.beginRobot(link.spec.name);
        addJoint(layout, "", link.spec.type);
    }
    for (const auto& link : experiment.springs) {
        layout.beginRobot(link.spec.name);
        addSpring(layout, "");
    }
    for (const RegionSpec& region : experiment.regions) {
        layout.beginRobot(region.name);
        for (const char* number : {"count", "entered", "left"})
            layout.add(number, "", SignalType::Integer, SignalDirection::Output);
        layout.add("inside", "", SignalType::Boolean, SignalDirection::Output,
                   std::max<std::uint32_t>(1, static_cast<std::uint32_t>(region.robots.size())));
    }
    return first;
}

std::uint32_t planRobot(SignalLayout& layout, const RobotSpec& robot) {
    layout.beginRobot(robot.name);
    const std::uint32_t first = addState(layout, "");
    for (const BodySpec& body : robot.config->bodies) addState(layout, body.name + "/");
    for (const JointSpec& joint : robot.config->joints) addJoint(layout, joint.name + "/", joint.type);
    for (const SpringSpec& spring : robot.config->springs) addSpring(layout, spring.name + "/");
    for (const GearSpec& gear : robot.config->gears) {
        const bool linear = robot.config->joints[static_cast<std::size_t>(gear.joint)].type == JointType::Slider;
        layout.add(gear.name + (linear ? "/force" : "/torque"), linear ? "N" : "N m", kReal, kTruth);
    }
    return first;
}

void planControllers(SignalLayout& layout, const RobotSpec& robot) {
    for (const ControllerSpec& controller : robot.controllers)
        for (const SignalDescription& s : controller.published)
            if (s.direction == TRUNDLE_OUTPUT)
                layout.add(controller.name + "/" + s.name, s.unit, static_cast<SignalType>(s.type), SignalDirection::Output,
                           signalCount(s, controller));
}

std::string signalUnit(const RobotConfigSpec& config, const ComponentSpec& device, std::string_view signal,
                       std::string_view unit) {
    if (isTarget(device, signal)) unit = device.text("Mode") == "speed" ? "rad/s" : "rad";
    const bool isRate = unit == "rad/s";
    if ((isRate || unit == "rad") && isOnSlider(config, device)) return isRate ? "m/s" : "m";
    return std::string(unit);
}

SignalLayout plannedLayout(const ExperimentSpec& experiment, const Registry& registry) {
    SignalLayout layout;
    for (const RobotSpec& robot : experiment.robots) {
        planRobot(layout, robot);
        for (const ComponentSpec& device : robot.config->devices) {
            const Kind* kind = registry.find(device.kind);
            if (!kind) continue;
            for (const SignalDescription& s : kind->signals)
                layout.add(device.name + "/" + s.name, signalUnit(*robot.config, device, s.name, s.unit),
                           static_cast<SignalType>(s.type), static_cast<SignalDirection>(s.direction), signalCount(s, device));
        }
        planControllers(layout, robot);
    }
    (void)planBetweenRobots(layout, experiment);
    return layout;
}

} // namespace trundle
