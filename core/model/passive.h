#pragma once
#include "model/experiment_spec.h"
#include "model/outline.h"

namespace trundle {

/// A robot that nothing drives and that senses nothing: no joint, no device, no controller. A ball or a crate, shown as an object.
[[nodiscard]] bool isPassive(const RobotSpec& robot);
/// The same of a Robot, Grid or Scatter as its text has it. `config`: the RobotConfig it names; null: that is not known, and it is none.
[[nodiscard]] bool isPassive(const Part& instance, const Part* config);

/// How many of each there are; together all robots of the experiment.
struct RobotCounts {
    std::size_t robots = 0, objects = 0;
};
[[nodiscard]] RobotCounts countRobots(const ExperimentSpec& experiment);

} // namespace trundle
