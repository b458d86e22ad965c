#pragma once
#include <string>
#include <vector>

#include "model/experiment_spec.h"
#include "schema/registry.h"

namespace trundle {

/// The devices that a path of the selection refers to, as "robot0.front": the device itself; of a robot, a Grid or a Scatter all
/// devices, and the controller if it publishes signals; of a part of a robot the devices that refer to it, or all; of a part of a
/// RobotConfig those of its first robot. Of one robot first what senses its surroundings, then motors, encoders and the like.
[[nodiscard]] std::vector<std::string> devicesOf(const ExperimentSpec& experiment, const Registry& kinds,
                                                 const std::string& path);

/// Those of all paths, each once.
[[nodiscard]] std::vector<std::string> devicesOf(const ExperimentSpec& experiment, const Registry& kinds,
                                                 const std::vector<std::string>& paths);

} // namespace trundle
