#pragma once
// Contacts of what stands on an end of a cylinder. A general collider finds the lowest point of the rim alone; on that a can rocks
// from one side to the other in each tick. Here it stands on all of the rim that is below.

#include "world/ode/collision/hull_on_mesh.h"

namespace trundle {

/// An end of a cylinder.
struct RoundEnd {
    Vec3 centre, outward; ///< m; unit
    double radius = 0;
};

/// A side of a box: `outward` is the cross product of the other two axes.
struct BoxSide {
    Vec3 centre, outward, along, across; ///< m; unit
    double halfAlong = 0, halfAcross = 0;
};

/// Cosine of the angle up to which a face and an end lie on each other: 2.6 degrees.
inline constexpr double kFlush = 0.999;
inline constexpr double kFlushSlope = 0.0447; ///< its sine

// All add what is below, with normals out of the ground: those of the plane, the side, the second end. An end may be oblique to a plane: its
// lowest point comes first.
void endOnPlane(const RoundEnd& end, const Vec3& normal, double offset, std::vector<SurfaceContact>& contacts);
void endOnSide(const RoundEnd& end, const BoxSide& side, std::vector<SurfaceContact>& contacts);
void endOnEnd(const RoundEnd& first, const RoundEnd& second, std::vector<SurfaceContact>& contacts);

/// Keeps four, or with `most` below that two: the deepest one, the farthest from it, and of those on each side of their line the farthest.
void keepWidest(std::vector<SurfaceContact>& contacts, int most);

} // namespace trundle
