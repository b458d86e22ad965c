#pragma once
#include "model/experiment_spec.h"
#include "model/outline.h"

namespace trundle {

/// Whether a robot has no joints, devices and controller, like a ball or a crate; the editor shows it as an object.
[[nodiscard]] bool isPassive(const RobotSpec& robot);
/// The same for a Robot, Grid or Scatter before it is resolved. `config`: its RobotConfig; null if unknown, which gives false.
[[nodiscard]] bool isPassive(const Part& instance, const Part* config);
/// Whether instances of a config without a controller are passive: a RobotConfig with bodies alone.
[[nodiscard]] bool isPassiveConfig(const Part& config);

/// Number of passive objects and of other robots, without what moves in Statics.
struct RobotCounts {
    std::size_t robots = 0, objects = 0;
};
[[nodiscard]] RobotCounts countRobots(const ExperimentSpec& experiment);

} // namespace trundle
