#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <trundle/geometry.h>

#include "model/experiment_spec.h"
#include "run/command.h"
#include "signals/block.h"
#include "signals/layout.h"

namespace trundle {

/// Pose of the robot's config frame in the world, from a signal block.
[[nodiscard]] std::optional<Pose> shownPose(const SignalLayout& layout, const SignalBlock& block, const RobotSpec& robot);
/// The block with robots moved to other poses, at rest, including all their bodies and what is joined to them. Of robots that are
/// joined at most one is in `placed`.
[[nodiscard]] std::shared_ptr<const SignalBlock> withPlaced(const SignalLayout& layout, const SignalBlock& block,
                                                            const ExperimentSpec& experiment,
                                                            const std::vector<PlaceCommand>& placed);

} // namespace trundle
