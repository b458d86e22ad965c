#pragma once
// Mass, centre of mass and inertia of shapes and bodies.

#include "base/result.h"
#include "model/body_spec.h"

namespace trundle {

/// Mass properties of a shape with density 1 kg/m^3, in its own frame: `mass` is its volume (m^3).
[[nodiscard]] Result<MassProperties> solidOf(const GeomSpec& geom);
/// The same for a closed mesh with either orientation. Fails for an open mesh.
[[nodiscard]] Result<MassProperties> solidOf(const TriangleMesh& mesh);

/// How physics takes a geom to be turned. A quarter turn to one side brings a cylinder or capsule where one to the other side does: of
/// both it is that to the left, so that a mirror image has the bits of a copy by hand, whichever that has.
[[nodiscard]] Quat shapeRotation(const GeomSpec& geom);

/// The properties scaled to another mass.
[[nodiscard]] MassProperties withMass(const MassProperties& solid, double mass);
/// The properties in the frame that `pose` is relative to.
[[nodiscard]] MassProperties placed(const MassProperties& solid, const Pose& pose);
[[nodiscard]] MassProperties sum(const std::vector<MassProperties>& parts);

/// Whether the mass properties are physically possible: finite, positive definite, and (for a given inertia) no principal moment
/// greater than the sum of the others.
[[nodiscard]] Status checkMass(const MassProperties& mass);

} // namespace trundle
