#pragma once
#include <string>

#include "scene/shapes/bounds.h"

class QPainter;
class QPointF;

namespace trundle {

struct ExperimentSpec;
class ToolView;

/// Paints the regions as translucent boxes with their names, those that are selected in the colour of the selection.
void paintRegions(QPainter& painter, const ToolView& view);

/// The region that has an edge at a place of the view, the nearest one; "" without one. A click inside of it means the floor.
[[nodiscard]] std::string regionAt(const ToolView& view, const QPointF& at);

/// World bounds of the regions that a path of the selection refers to; empty: none.
[[nodiscard]] Bounds boundsOfRegions(const ExperimentSpec& experiment, const std::string& path);

} // namespace trundle
