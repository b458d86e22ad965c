#pragma once
class QPainter;

namespace trundle {

class View;

/// Paints the lines between radios that can reach each other.
void paintRadioLinks(QPainter& painter, const View& view);
/// Paints the legend of lobes, links and coverage, in the upper right corner.
void paintRadioLegend(QPainter& painter, const View& view);

} // namespace trundle
