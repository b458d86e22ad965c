#pragma once
#include "model/body_spec.h"

namespace trundle {

/// Whether a point (the mesh's frame) is in the volume that the mesh's triangles enclose, their corners counter-clockwise as seen from
/// outside. False in a room whose walls face inwards, and above or below a terrain.
[[nodiscard]] bool isInside(const TriangleMesh& mesh, const Vec3& point);

} // namespace trundle
