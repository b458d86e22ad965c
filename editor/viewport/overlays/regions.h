#pragma once
class QPainter;

namespace trundle {

class ToolView;

/// Paints the regions as translucent boxes with their names, those that are selected in the colour of the selection.
void paintRegions(QPainter& painter, const ToolView& view);

/// The region that has an edge at a place of the view, the nearest one; "" without one. A click inside of it means the floor.
[[nodiscard]] std::string regionAt(const ToolView& view, const QPointF& at);

} // namespace trundle
