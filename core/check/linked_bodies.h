#pragma once
#include "model/experiment_spec.h"

namespace trundle {

/// What joints and springs at the top level join, as one config without a name whose frame is the world's: each body once, without its
/// geoms, and named after its robot. Of a block that a Repeat has several times only the first one.
[[nodiscard]] RobotConfigSpec linkedBodies(const ExperimentSpec& experiment);

} // namespace trundle
