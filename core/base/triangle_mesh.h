#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace trundle {

struct MeshLook; // base/mesh_look.h

/// Metres, z up. Indices are below points.size(); points are finite (its reader promises both).
struct TriangleMesh {
    std::vector<std::array<double, 3>> points;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::shared_ptr<const MeshLook> look; ///< by its own file; null where that says nothing of looks
};

/// Grey values 0 (black) .. 1 (white), row 0 at the top of the picture (+y). At least 2 x 2.
struct HeightMap {
    std::uint32_t columns = 0, rows = 0;
    std::vector<float> heights; ///< row by row
};

} // namespace trundle
