#pragma once
#include <optional>
#include <string>

#include <trundle/geometry.h>

#include "model/experiment_spec.h"
#include "scene/poses.h"
#include "signals/block.h"
#include "signals/layout.h"

namespace trundle {

/// Pose of a robot's config frame as a block of signals has it.
[[nodiscard]] std::optional<Pose> shownPose(const SignalLayout& layout, const SignalBlock& block, const std::string& robot);
/// Moves all bodies of one robot rigidly.
void moveRobot(BodyPoses& poses, const ExperimentSpec& experiment, const std::string& robot, const Pose& motion);

} // namespace trundle
