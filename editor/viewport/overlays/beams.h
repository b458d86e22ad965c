#pragma once
#include <span>
#include <vector>

#include "run/live/live_state.h"
#include "scene/queries/range_model.h"

class QPainter;

namespace trundle {

class ToolView;

/// Draws what distance sensors measure, of all of them or of the selected ones only: a fan as the area that its beams crossed,
/// with a dot where each hit something, a cone up to its distance. Without a reading, their reach. Of many beams a few are drawn.
void paintBeams(QPainter& painter, const ToolView& view, bool all);

/// The distances of a sensor, one for each of its directions; empty before its first reading.
[[nodiscard]] std::span<const double> distancesOf(const RangeModel& sensor, const SignalLayout& layout,
                                                  const LiveSnapshot& snapshot);
/// The pose of its body when the reading was measured: the body is moved back by its velocity. `body` is the pose at the
/// snapshot.
[[nodiscard]] Pose poseAtReading(const RangeModel& sensor, const std::string& bodyName, const SignalLayout& layout,
                                 const LiveSnapshot& snapshot, const Pose& body);

} // namespace trundle
