#pragma once
// Contacts along a line: the straight side of a cylinder or capsule on a flat face, or along another such side. A general collider
// finds one deepest point there, which jumps from end to end; here a body rests on both ends of what it covers.

#include "world/ode/collision/hull_on_mesh.h"

namespace trundle {

/// The straight side of a cylinder or capsule.
struct RoundSide {
    Vec3 centre, axis; ///< m; unit
    double radius = 0, half = 0;
    bool hasRoundEnds = false; ///< a capsule's
};

/// Adds the ends of the line that the side covers of the face whose normal is nearest to `normal`, which points towards the side.
/// False if it covers none: an edge or the end of the side touches.
[[nodiscard]] bool sideOnFace(const RoundSide& side, const FlatBody& body, const Vec3& normal,
                              std::vector<SurfaceContact>& contacts);

/// Adds the ends of what two sides have in common, if they are nearly parallel. `normal`, and those of the contacts, point towards the
/// first.
[[nodiscard]] bool sideOnSide(const RoundSide& first, const RoundSide& second, const Vec3& normal,
                              std::vector<SurfaceContact>& contacts);

} // namespace trundle
