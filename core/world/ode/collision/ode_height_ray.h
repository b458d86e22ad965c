#pragma once
// Ray casts against height maps, cell by cell: ODE's own test visits every cell below the ray's bounding box.

#include <optional>

#include <trundle/geometry.h>

#include "base/triangle_mesh.h"

namespace trundle {

/// In the height field's own axes: x along columns, y up, z along rows. `direction` is a unit vector.
struct HeightRay {
    Vec3 origin, direction;
    double range = 0;
};
struct HeightHit {
    double distance = 0;
    Vec3 normal = Vec3::UnitY();
};

/// The map spans `width` x `depth` around the origin (m); white is at `height`.
[[nodiscard]] std::optional<HeightHit> rayOnHeights(const HeightRay& ray, const HeightMap& map, double width, double depth,
                                                    double height);

} // namespace trundle
