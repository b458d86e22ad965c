#pragma once
// Mass over a view: centres of mass, inertia as ellipsoids, and what robots rest on.

#include <vector>

#include "editor/viewport/context/label.h"

namespace trundle {

class ToolView;

/// Of each body, and larger of each robot as a whole.
void paintCentresOfMass(QPainter& painter, const ToolView& view);
/// The ellipsoids of the selected bodies and robots; of all robots without a selection.
void paintInertia(QPainter& painter, const ToolView& view);
/// The support polygons on the ground, with the centre of mass above and its distance from the nearest edge.
void paintSupport(QPainter& painter, const ToolView& view);
/// Its labels: of each robot how it balances and, at its nearest edge, on what slope it turns over there; of other edges as there is room.
[[nodiscard]] std::vector<PlacedLabel> supportLabels(const ToolView& view);

} // namespace trundle
