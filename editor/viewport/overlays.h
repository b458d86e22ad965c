#pragma once
class QPainter;

namespace trundle {

class View;

/// Paints the overlays enabled in the view's settings: names, joints, contacts, centres of mass, trails, scale bar, axes.
void paintOverlays(QPainter& painter, const View& view);

} // namespace trundle
