#pragma once
// A mesh as several convex hulls, for its collisions.

#include <vector>

#include "base/triangle_mesh.h"

namespace trundle {

/// Hulls that cover the mesh together, and how far the surface of the mesh is from theirs.
struct ConvexParts {
    std::vector<TriangleMesh> hulls; ///< in the frame of the mesh
    std::vector<double> volumes;     ///< m^3, of each
    double largest = 0, mean = 0;    ///< m, over corners and middles of triangles
};

/// Cuts the mesh along its axes until its hulls hold little that it does not, in `most` parts at most. A mesh that is not closed counts as
/// solid where it encloses space, otherwise as its surface. Deterministic. Empty if it has no triangles or is flat.
[[nodiscard]] ConvexParts convexPartsOf(const TriangleMesh& mesh, std::size_t most = 12);

} // namespace trundle
