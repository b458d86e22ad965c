#pragma once
class QPainter;

namespace trundle {

class ToolView;

/// Paints the lines between radios that can reach each other.
void paintRadioLinks(QPainter& painter, const ToolView& view);
/// Paints the legend of lobes, links and coverage, in the upper right corner.
void paintRadioLegend(QPainter& painter, const ToolView& view);

} // namespace trundle
