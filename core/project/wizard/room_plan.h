#pragma once
// Rooms and mazes as walls.

#include <cstdint>
#include <string>
#include <vector>

#include "base/result.h"

namespace trundle {

/// A wall by its middle and its sides along x and y, m.
struct RoomWall {
    std::string name;
    double x = 0, y = 0, along = 0, across = 0;
};

/// The walls of a room or a maze around the origin.
struct RoomPlan {
    std::vector<RoomWall> walls;
    double length = 0, width = 0;  ///< m, along x and y, outside
    double height = 0.5;           ///< m, of the walls
    double startX = 0, startY = 0; ///< a free place for a robot, m
};

enum class RoomSide { None, North, East, South, West };

struct RoomOptions {
    double length = 4, width = 3; ///< m, along x and y, inside
    double height = 0.5, thickness = 0.1;
    RoomSide doorSide = RoomSide::None;
    double doorWidth = 0.8; ///< m, of an opening in the middle of that side
};
/// Fails if a number is out of range or the door is wider than its side.
[[nodiscard]] Result<RoomPlan> roomPlan(const RoomOptions& options);

/// "a room, 4 m x 3 m inside, with a door 0.8 m wide in the south".
[[nodiscard]] std::string describe(const RoomOptions& options);

/// A perfect maze: one way, and only one, leads from each cell to each other. Start is the middle of the lower left cell.
struct MazeOptions {
    int rows = 6, columns = 8;
    double cell = 0.6; ///< m, from the middle of a wall to that of the next
    double height = 0.3, thickness = 0.05;
    std::uint64_t seed = 1;
};
/// Walls in one line are one box. The same for the same seed on any machine. Fails if a number is out of range.
[[nodiscard]] Result<RoomPlan> mazePlan(const MazeOptions& options);
/// "a maze of 6 rows and 8 columns, of the seed 1".
[[nodiscard]] std::string describe(const MazeOptions& options);

} // namespace trundle
