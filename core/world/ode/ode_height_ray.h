#pragma once
// Rays on height maps, cell by cell: ODE's own test looks at every cell under the ray's bounding box.

#include <optional>

#include <trundle/geometry.h>

#include "base/triangle_mesh.h"

namespace trundle {

/// In the field's own axes: x along columns, y up, z along rows. `direction` is a unit vector.
struct HeightRay {
    Vec3 origin, direction;
    double range = 0;
};
struct HeightHit {
    double distance = 0;
    Vec3 normal = Vec3::UnitY();
};

/// The map spans `width` by `depth` about the origin; white is `height` up.
[[nodiscard]] std::optional<HeightHit> rayOnHeights(const HeightRay& ray, const HeightMap& map, double width, double depth,
                                                    double height);

} // namespace trundle
