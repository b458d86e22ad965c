#pragma once
class QPainter;

namespace trundle {

class ToolView;

/// Draws camera frusta from the near to the far plane as thin lines, for all cameras or for the selected ones only.
void paintFrusta(QPainter& painter, const ToolView& view, bool all);

} // namespace trundle
