#pragma once
class QPainter;

namespace trundle {

class View;

/// Draws camera frusta from the near to the far plane as thin lines, for all cameras or for the selected ones only.
void paintFrusta(QPainter& painter, const View& view, bool all);

} // namespace trundle
