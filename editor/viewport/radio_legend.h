#pragma once
class QPainter;

namespace trundle {

class View;

/// The lines between radios that reach each other.
void paintRadioLinks(QPainter& painter, const View& view);
/// What the colours of lobes, links and coverage mean, in the upper right corner.
void paintRadioLegend(QPainter& painter, const View& view);

} // namespace trundle
