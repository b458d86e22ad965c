#pragma once
// Where something put on a flat face comes to lie: at its middle, at its edges, on the axes of the object, or in steps.

#include <array>
#include <optional>
#include <vector>

#include "scene/queries/ray_cast.h"
#include "scene/shapes/bounds.h"

namespace trundle {

/// A side of a box, an end of a cylinder (as the square around it), the line along the side of a cylinder, or a face of a mesh across one
/// of its axes (as wide as the mesh). World coordinates.
struct FlatFace {
    Vec3 middle = Vec3::Zero();
    Quat rotation = Quat::Identity(); ///< x and y along the face, z along its outward normal
    std::array<double, 2> half{};     ///< extent to each side along x and y, m; 0: none to snap in

    /// The face that was hit; nothing where it is not flat. `owner`: pose of the geom's body or static.
    [[nodiscard]] static std::optional<FlatFace> of(const GeomSpec& geom, const Pose& owner, const RayHit& hit);
};

struct FaceSnapOptions {
    Bounds thing;                 ///< extent of what is put there, around its origin, in the face's frame; empty: a point
    Vec3 origin = Vec3::Zero();   ///< of the object that has the face: its axes cross the face
    double step = 0;              ///< m, along the world's axes, from the world's origin; 0: none
    std::array<double, 2> near{}; ///< m, along x and y of the face: what is farther away is not snapped to
};

struct FaceSnap {
    Vec3 point = Vec3::Zero();               ///< on the face, world coordinates
    std::vector<std::array<Vec3, 2>> guides; ///< the lines of the face that it was snapped to, from end to end
};

/// The nearest, in each of the two directions, of: the middle of the face, the places where an edge of the thing is at an edge of the
/// face, the axes of the object, and multiples of the step. Where none is near the point stays as it is.
[[nodiscard]] FaceSnap snapOnFace(const FlatFace& face, const Vec3& point, const FaceSnapOptions& options);

} // namespace trundle
