#pragma once
class QPainter;

namespace trundle {

class ToolView;

/// Paints the regions as translucent boxes with their names, those that are selected in the colour of the selection.
void paintRegions(QPainter& painter, const ToolView& view);

} // namespace trundle
