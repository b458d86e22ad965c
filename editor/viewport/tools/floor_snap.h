#pragma once
// Where the next corner of a path on the floor goes: directions, right angles, steps of the grid, and ends of walls.

#include <optional>
#include <vector>

#include "project/wizard/floor_path.h"

namespace trundle {

class ObjectIndex;

/// A corner, and what it snapped to.
struct FloorSnap {
    enum class To { Nothing, Grid, Direction, RightAngle, End };
    FloorPoint point{};
    To to = To::Nothing;
};

struct FloorSnapOptions {
    double step = 0.05;           ///< m; 0: no snapping
    double directions = 15;       ///< degrees
    std::optional<double> length; ///< m, as typed
    std::optional<double> angle;  ///< degrees from x, as typed
};
/// The corner for a point under the cursor, after these corners.
[[nodiscard]] FloorSnap snapOnFloor(const FloorPoint& cursor, const std::vector<FloorPoint>& corners,
                                    const FloorSnapOptions& options);

/// Degrees from x, above -180 and up to 180.
[[nodiscard]] double headingBetween(const FloorPoint& from, const FloorPoint& to);

/// The ends of the middle lines of upright walls, in W; where two of them meet, that corner.
[[nodiscard]] std::vector<FloorPoint> wallEnds(const ObjectIndex& objects);

} // namespace trundle
