#pragma once
// A direction that is turned by dragging the end of its arrow.

#include <array>

#include "scene/queries/camera_view.h"
#include "scene/queries/ray_cast.h"

namespace trundle {

/// The directions from `centre` to what is under the ray on the sphere on which the arrow's end turns: first the one on the side of the
/// sphere where `before` was, then the one on the other side; beside the sphere both are on its outline. Unit vectors, m, one frame for all.
[[nodiscard]] std::array<Vec3, 2> directionsUnder(const ViewRay& ray, const Vec3& centre, const Vec3& before, double length);

/// The main axis that one of them is near; otherwise the first, with heading and elevation in steps.
[[nodiscard]] Vec3 snappedDirection(const std::array<Vec3, 2>& directions, double stepDegrees);

} // namespace trundle
