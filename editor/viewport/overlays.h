#pragma once
class QPainter;

namespace trundle {

class View;

/// What the settings of a view want over its picture: names, joints, contacts, centres of mass, trails, scale bar, axes.
void paintOverlays(QPainter& painter, const View& view);

} // namespace trundle
