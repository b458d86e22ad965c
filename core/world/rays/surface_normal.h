#pragma once
#include <trundle/geometry.h>

#include "world/rays/ray_kernel.h"

namespace trundle {

/// Outward normal of a convex shape or plane at a point of its surface, in its axes.
[[nodiscard]] Vec3 normalOf(const RayShape& shape, const Vec3& point);

} // namespace trundle
