#pragma once
// Walls from the picture of a floor plan: which of its pixels are wall, merged into few boxes.

#include <cstdint>
#include <optional>
#include <vector>

#include "base/result.h"
#include "base/triangle_mesh.h"

namespace trundle {

struct FloorPlanOptions {
    double threshold = 0.5;       ///< of the brightness, 0 to 1: what is darker is wall
    bool isInverted = false;      ///< what is lighter is wall
    double width = 10;            ///< m, of the whole picture
    std::size_t mostBoxes = 2000; ///< a picture that needs more is made coarser
};

/// A wall, in cells from the upper left corner.
struct PlanBox {
    std::uint32_t x = 0, y = 0, width = 0, height = 0;
    bool operator==(const PlanBox&) const = default;
};

/// Cells in rows from the top, as the picture; its middle is the origin, x to the right and y up.
struct FloorPlan {
    std::uint32_t columns = 0, rows = 0;
    double cell = 0;        ///< m, of a side of a cell
    std::uint32_t step = 1; ///< pixels of the picture along a cell
    std::vector<PlanBox> walls;
    std::array<double, 2> freest{}; ///< m: where the walls and the edges are farthest away
    double room = 0;                ///< m from there to the nearest of them
};

/// Fails if nothing of the picture is wall, or all of it, and if an option is out of range.
[[nodiscard]] Result<FloorPlan> floorPlanFrom(const HeightMap& picture, const FloorPlanOptions& options);

} // namespace trundle
