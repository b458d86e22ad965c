#pragma once
// The radios of an experiment as whoever draws sees them, and what stands between two antennas.

#include <memory>
#include <vector>

#include "radio/radio_nodes.h"
#include "scene/object_index.h"

namespace trundle {

/// Robots in text order, of each its Transceivers in text order: as a run numbers them, unless a module's devices have radios too.
[[nodiscard]] std::vector<RadioNode> radioNodesOf(const ExperimentSpec& experiment);

/// Counts as a run does: each solid between once, the bodies of the two radios' own robots left out. For RadioNodes::setWalls().
[[nodiscard]] WallCount wallsBetween(std::shared_ptr<const ObjectIndex> objects, std::shared_ptr<const BodyPoses> poses,
                                     const std::vector<RadioNode>& nodes);

} // namespace trundle
