#pragma once
#include "model/experiment_spec.h"
#include "run/command.h"
#include "world/world.h"

namespace trundle {

/// Writes one command signal. Fails if no command has this name, or if the value is not finite.
[[nodiscard]] Status setSignal(World& world, const SignalCommand& signal);
/// All command signals of the devices of a robot.
void setCommandsToZero(World& world, const RobotSpec& robot);

} // namespace trundle
