#pragma once
#include "model/body_spec.h"

namespace trundle {

/// Whether a point (in the mesh's frame) is inside the volume enclosed by the mesh's triangles, whose corners run
/// counter-clockwise seen from outside. False in a room whose walls face inwards, and above or below a terrain.
[[nodiscard]] bool isInside(const TriangleMesh& mesh, const Vec3& point);

} // namespace trundle
