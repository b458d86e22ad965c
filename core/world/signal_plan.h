#pragma once
// Which signals a robot has, before any world is built.

#include "model/experiment_spec.h"
#include "schema/registry.h"
#include "signals/layout.h"

namespace trundle {

/// Has an angle or a way of its own.
[[nodiscard]] constexpr bool hasPosition(JointType type) { return type != JointType::Ball && type != JointType::Fixed; }

/// Opens the robot's image and adds what every robot has: its pose and velocity, its bodies', its joints' positions and rates. Gives
/// the first slot.
std::uint32_t planRobot(SignalLayout& layout, const RobotSpec& robot);

/// Adds what the robot's controller publishes: "robot0/brain/hops". Last in the robot's image.
void planController(SignalLayout& layout, const RobotSpec& robot);

/// The layout that a world of this experiment has. Devices of kinds that the registry does not know have no signals in it.
[[nodiscard]] SignalLayout plannedLayout(const ExperimentSpec& experiment, const Registry& registry);

} // namespace trundle
