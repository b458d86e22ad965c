#pragma once
#include <array>
#include <cstdint>
#include <vector>

namespace trundle {

/// Metres, z up. Indices are below points.size(); points are finite (its reader promises both).
struct TriangleMesh {
    std::vector<std::array<double, 3>> points;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// Grey values 0 (black) .. 1 (white), row 0 at the top of the picture (+y). At least 2 x 2.
struct HeightMap {
    std::uint32_t columns = 0, rows = 0;
    std::vector<float> heights; ///< row by row
};

} // namespace trundle
