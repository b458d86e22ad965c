#pragma once
#include <optional>

#include "base/triangle_mesh.h"

namespace trundle {

/// The convex hull of the points as a closed mesh, triangles counter-clockwise seen from outside. Deterministic. Nothing if all
/// points are in one plane, on a line or at one position.
[[nodiscard]] std::optional<TriangleMesh> convexHull(const std::vector<std::array<double, 3>>& points);

/// At most `most` points: the extreme ones in `most` directions spread over the sphere. All points if there are no more than
/// that.
[[nodiscard]] std::vector<std::array<double, 3>> farthestPoints(const std::vector<std::array<double, 3>>& points,
                                                                std::size_t most);

} // namespace trundle
