#pragma once
// Contacts of a cylinder with a box that ODE misses: its own collider cuts the deepest line of the cylinder's side with the box, and
// finds nothing where that line runs past the face that the cylinder is in.

#include "world/ode/collision/hull_contact.h"

namespace trundle {

struct PlacedCylinder {
    Vec3 centre;
    Mat3 axes; ///< about z
    double radius = 0, half = 0;
};
struct PlacedBox {
    Vec3 centre;
    Mat3 axes;
    Vec3 half;
};

/// By more than 10 um; of two faces that are within 3 degrees of each other by more than 2 mm.
[[nodiscard]] bool overlap(const PlacedCylinder& cylinder, const PlacedBox& box);

/// The touch of the pair, which becomes these two. The normal towards the cylinder; no contacts if they do not overlap, or if only edges cross.
[[nodiscard]] const FlatTouch& cylinderOnBox(const PlacedCylinder& cylinder, const PlacedBox& box, FlatPair& pair);

} // namespace trundle
