#pragma once
class QPainter;

namespace trundle {

class ToolView;

/// Paints the springs between two bodies as coils, those that are selected in the colour of the selection.
void paintSprings(QPainter& painter, const ToolView& view);

} // namespace trundle
