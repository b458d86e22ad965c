#pragma once
#include <string_view>

class QPainter;

namespace trundle {

class ToolView;

/// Paints the overlays enabled in the view's settings: names, joints, contacts, centres of mass, trails, scale bar, axes.
void paintOverlays(QPainter& painter, const ToolView& view);
/// Whether something is selected by its path, "row_3.goal", or by that of all members of a Repeat, Grid or Scatter, "row.goal".
[[nodiscard]] bool isSelected(const ToolView& view, std::string_view name);

} // namespace trundle
