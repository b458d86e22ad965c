#pragma once
// Mass, centre of mass and inertia of shapes and of what is put together from them.

#include "base/result.h"
#include "model/body_spec.h"

namespace trundle {

/// Of a body of density 1 kg/m^3, in the shape's own frame: `mass` is its volume.
[[nodiscard]] Result<MassProperties> solidOf(const GeomSpec& geom);
/// The same for a closed mesh, whichever way round its triangles are. Fails for an open one.
[[nodiscard]] Result<MassProperties> solidOf(const TriangleMesh& mesh);

/// Scaled to another mass.
[[nodiscard]] MassProperties withMass(const MassProperties& solid, double mass);
/// As seen from the frame in which `pose` stands.
[[nodiscard]] MassProperties placed(const MassProperties& solid, const Pose& pose);
[[nodiscard]] MassProperties sum(const std::vector<MassProperties>& parts);

/// Whether a body can have it: finite, positive definite, and (for a given inertia) no principal moment above the sum of the others.
[[nodiscard]] Status checkMass(const MassProperties& mass);

} // namespace trundle
