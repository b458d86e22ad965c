#pragma once
// The texts of a new arena: its walls as a StaticConfig, and an experiment with a robot in it.

#include <array>
#include <string>

#include "base/result.h"
#include "project/wizard/floor_plan.h"
#include "project/wizard/obstacle_field.h"
#include "project/wizard/room_plan.h"

namespace trundle {

/// A StaticConfig `name` with a floor and a Box for each wall, `height` m high. `source`: the file name of the picture, for a comment.
[[nodiscard]] std::string arenaText(const std::string& name, const FloorPlan& plan, double height, const std::string& source);

/// A room with boxes and cylinders in it; its middle is free. Fails if a number is out of range or that many have no room.
[[nodiscard]] Result<std::string> obstacleText(const std::string& name, const ObstacleField& field);

/// The obstacles alone: a StaticConfig of them with its Static, for an experiment; their geoms, for a StaticConfig. The floor if it is asked
/// for.
[[nodiscard]] std::string obstacleBlocksText(const std::string& name, const std::vector<FieldObstacle>& obstacles, bool hasFloor);
[[nodiscard]] std::string obstacleGeomsText(const std::vector<FieldObstacle>& obstacles, bool hasFloor);

/// A StaticConfig `name` with a floor and the walls of a room or a maze. `comment`: what it is.
[[nodiscard]] std::string roomText(const std::string& name, const RoomPlan& plan, const std::string& comment);
/// The same for an experiment, with a Static of it whose middle is at `place` (m); the floor if it is asked for.
[[nodiscard]] std::string roomBlocksText(const std::string& name, const RoomPlan& plan, bool hasFloor,
                                         const std::array<double, 2>& place = {});
/// The walls alone, for a StaticConfig.
[[nodiscard]] std::string roomBoxesText(const RoomPlan& plan, bool hasFloor, const std::array<double, 2>& place = {});

/// The arena of `file`.sim with a robot at `place` (m), to look at and to drive; `across`: m, of the whole arena; `floor`: m, z below it.
[[nodiscard]] std::string arenaExperimentText(const std::string& name, const std::string& file,
                                              const std::array<double, 2>& place, double across, double floor = 0);

} // namespace trundle
