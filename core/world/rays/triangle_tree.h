#pragma once
// A tree of boxes over the triangles of a mesh, for rays. Method: binned surface-area heuristic (Wald, "On fast construction of SAH-based
// bounding volume hierarchies", 2007), leaves of about two triangles.

#include <array>
#include <span>
#include <vector>

#include <trundle/geometry.h>

#include "world/rays/ray_kernel.h"

namespace trundle {

class TriangleTree {
public:
    /// Corners of each triangle, one after the other, in the mesh's axes.
    explicit TriangleTree(std::span<const std::array<Vec3, 3>> triangles);

    [[nodiscard]] const std::vector<TreeNode>& nodes() const { return m_nodes; }
    [[nodiscard]] const std::vector<RayTriangle>& triangles() const { return m_triangles; }
    /// Of the plane of a triangle, which side is not defined.
    [[nodiscard]] Vec3 normal(std::size_t triangle) const;

private:
    void split(int node, int first, int count, int depth);

    std::vector<TreeNode> m_nodes;
    std::vector<RayTriangle> m_triangles; ///< leaves have runs of them
};

} // namespace trundle
