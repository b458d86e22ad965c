#pragma once
#include <optional>

#include "base/triangle_mesh.h"

namespace trundle {

/// The convex hull of the points as a closed mesh whose triangles are counter-clockwise seen from outside.
/// The same points give the same hull. Nothing when the points lie in a plane, on a line or in one place.
[[nodiscard]] std::optional<TriangleMesh> convexHull(const std::vector<std::array<double, 3>>& points);

/// At most `most` of the points: those that reach farthest in as many directions spread over the sphere. All of them where they are no more.
[[nodiscard]] std::vector<std::array<double, 3>> farthestPoints(const std::vector<std::array<double, 3>>& points,
                                                                std::size_t most);

} // namespace trundle
