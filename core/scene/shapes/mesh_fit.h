#pragma once
// Simple shapes around a mesh, for its collisions.

#include <vector>

#include "base/triangle_mesh.h"
#include "model/body_spec.h"

namespace trundle {

/// A shape that contains the mesh, and how far the surface of the mesh is from its own.
struct MeshFit {
    GeomSpec geom;                ///< with its pose in the frame of the mesh; Convex: with the hull as its mesh
    double largest = 0, mean = 0; ///< m, over corners and middles of triangles
};

/// Box, Cylinder, Sphere, Capsule and Convex, in this order; round ones along x, y or z, whichever is nearest. Convex is missing if the mesh
/// is flat; all if it has no triangles.
[[nodiscard]] std::vector<MeshFit> fitsAround(const TriangleMesh& mesh);

} // namespace trundle
