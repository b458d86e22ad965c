#pragma once
// The texts of a new arena: its walls as a StaticConfig, and an experiment with a robot in it.

#include <cstdint>
#include <string>
#include <vector>

#include "base/result.h"
#include "project/wizard/floor_plan.h"
#include "project/wizard/room_plan.h"

namespace trundle {

/// A StaticConfig `name` with a floor and a Box for each wall, `height` m high. `source`: the file name of the picture, for a comment.
[[nodiscard]] std::string arenaText(const std::string& name, const FloorPlan& plan, double height, const std::string& source);

/// Obstacles in a room, the same for the same seed on any machine.
struct ObstacleField {
    double length = 6, width = 4; ///< m, inside
    int count = 12;
    double least = 0.15, most = 0.5; ///< m, across an obstacle
    double apart = 0.35;             ///< m, least between two of them, and around the middle
    std::uint64_t seed = 1;
};
/// A room with boxes and cylinders in it; its middle is free. Fails if a number is out of range or that many have no room.
[[nodiscard]] Result<std::string> obstacleText(const std::string& name, const ObstacleField& field);

/// A StaticConfig `name` with a floor and the walls of a room or a maze. `comment`: what it is.
[[nodiscard]] std::string roomText(const std::string& name, const RoomPlan& plan, const std::string& comment);
/// The same for an experiment, with a Static of it; the floor if it is asked for.
[[nodiscard]] std::string roomBlocksText(const std::string& name, const RoomPlan& plan, bool hasFloor);
/// The walls alone, for a StaticConfig.
[[nodiscard]] std::string roomBoxesText(const RoomPlan& plan, bool hasFloor);

/// The arena of `file`.sim with a robot at `place` (m), to look at and to drive; `across`: m, of the whole arena; `floor`: m, z below it.
[[nodiscard]] std::string arenaExperimentText(const std::string& name, const std::string& file,
                                              const std::array<double, 2>& place, double across, double floor = 0);

} // namespace trundle
