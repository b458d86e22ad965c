#pragma once
class QPainter;

namespace trundle {

class ToolView;

/// Paints the overlays enabled in the view's settings: names, joints, contacts, centres of mass, trails, scale bar, axes.
void paintOverlays(QPainter& painter, const ToolView& view);

} // namespace trundle
