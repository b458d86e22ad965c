#pragma once
// The signals of a robot, determined without building a world.

#include "model/experiment_spec.h"
#include "schema/registry.h"
#include "signals/layout.h"

namespace trundle {

/// True for joints with a single angle or displacement.
[[nodiscard]] constexpr bool hasPosition(JointType type) { return type != JointType::Ball && type != JointType::Fixed; }

/// Starts the robot's range of slots and adds the signals every robot has: its pose and velocity, those of its bodies, its
/// joints' positions and rates. Returns the first slot.
std::uint32_t planRobot(SignalLayout& layout, const RobotSpec& robot);

/// Adds the signals that the robot's controller publishes: "robot0/brain/hops". Called last for the robot.
void planController(SignalLayout& layout, const RobotSpec& robot);

/// The layout of a world of this experiment. Devices of kinds missing in the registry have no signals in it.
[[nodiscard]] SignalLayout plannedLayout(const ExperimentSpec& experiment, const Registry& registry);

} // namespace trundle
