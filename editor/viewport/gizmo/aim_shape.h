#pragma once
// What a view shows of where a device looks or sends, as lines: it can be dragged to aim the device.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <QPointF>

#include <trundle/geometry.h>

namespace trundle {

class ToolView;

using AimLine = std::array<Vec3, 2>; ///< in W

/// The frustum of a camera, the beams or the cone of a distance sensor, and three great circles of an antenna's lobe while lobes are shown.
[[nodiscard]] std::vector<AimLine> aimShapeOf(const ToolView& view, const std::string& device);

/// The point of the lines that is nearest to a pixel, if it is within `reach` pixels.
[[nodiscard]] std::optional<Vec3> pointUnder(const ToolView& view, const std::vector<AimLine>& lines, const QPointF& at,
                                             double reach);

} // namespace trundle
