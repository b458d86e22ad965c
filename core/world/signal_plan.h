#pragma once
// The signals of a robot, determined without building a world.

#include <string>
#include <string_view>

#include "model/experiment_spec.h"
#include "model/signal_count.h"
#include "schema/registry.h"
#include "signals/layout.h"

namespace trundle {

/// True for joints with a single angle or displacement.
[[nodiscard]] constexpr bool hasPosition(JointType type) { return type != JointType::Ball && type != JointType::Fixed; }

/// Numbers in a signal by the table of the device's code; where the text gives no value, with the code's default. Not limited.
[[nodiscard]] std::uint64_t signalCount(const TrundleKind& kind, const TrundleSignal& signal, const ComponentSpec& device);

/// The unit of a device's signal. What a servo or linear motor is to reach depends on its Mode, so that its kind gives no unit; and on a
/// Slider what is an angle elsewhere is a way.
[[nodiscard]] std::string signalUnit(const RobotConfigSpec& config, const ComponentSpec& device, std::string_view signal,
                                     std::string_view unit);

/// Starts the robot's range of slots and adds the signals every robot has: its pose and velocity, those of its bodies, its
/// joints' positions and rates, what springs and gears do. Returns the first slot.
std::uint32_t planRobot(SignalLayout& layout, const RobotSpec& robot);

/// Adds the signals that the robot's controller publishes: "robot0/brain/hops". Called last for the robot.
void planControllers(SignalLayout& layout, const RobotSpec& robot);

/// Adds what joints and springs at the top level, and regions, report. Called last. Returns the first slot.
std::uint32_t planBetweenRobots(SignalLayout& layout, const ExperimentSpec& experiment);

/// The layout of a world of this experiment. Devices of kinds missing in the registry have no signals in it.
[[nodiscard]] SignalLayout plannedLayout(const ExperimentSpec& experiment, const Registry& registry);

} // namespace trundle
