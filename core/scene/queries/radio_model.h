#pragma once
// Radio nodes of an experiment for display, and the obstacles between two antennas.

#include <memory>
#include <vector>

#include "radio/radio_nodes.h"
#include "scene/queries/object_index.h"

namespace trundle {

/// Robots in text order, and for each its Transceivers in text order. A run uses the same numbers, unless devices of a module
/// have radios too.
[[nodiscard]] std::vector<RadioNode> radioNodesOf(const ExperimentSpec& experiment);

/// Counts walls as a run does: each solid between the radios once, without the bodies of the two radios' own robots. For
/// RadioNodes::setWalls().
[[nodiscard]] WallCount wallsBetween(std::shared_ptr<const ObjectIndex> objects, std::shared_ptr<const BodyPoses> poses,
                                     const std::vector<RadioNode>& nodes);

} // namespace trundle
