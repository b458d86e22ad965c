#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace trundle {

struct MeshAppearance; // base/mesh_appearance.h

/// In metres, z up; triangles are counter-clockwise seen from outside. Indices are below points.size() and points are finite (both
/// guaranteed by the mesh reader).
struct TriangleMesh {
    std::vector<std::array<double, 3>> points;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::shared_ptr<const MeshAppearance> look; ///< appearance from its own file; null if the file has none
};

/// Exchanges two corners, with their texture coordinates, of each triangle whose flag is set: its back becomes its front.
void reverseTriangles(TriangleMesh& mesh, const std::vector<bool>& which);

/// Grey values from 0 (black) to 1 (white), row 0 at the top of the picture (+y). At least 2 x 2.
struct HeightMap {
    std::uint32_t columns = 0, rows = 0;
    std::vector<float> heights; ///< row-major
};

} // namespace trundle
