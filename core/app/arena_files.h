#pragma once
// A new arena with an experiment to drive through it, as files.

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "app/locations.h"
#include "base/result.h"
#include "project/wizard/arena_text.h"
#include "project/wizard/heights_text.h"

namespace trundle {

/// An arena whose files are written.
struct NewArena {
    std::string folder;             ///< as given, with the arena's own folder
    std::vector<std::string> files; ///< in that folder: the arena, the experiment
    std::string experiment;
};

/// PNG, JPEG, BMP, PGM or PPM, read by another process. Fails with the reason.
[[nodiscard]] Result<std::shared_ptr<const HeightMap>> readPlanPicture(const std::string& picture, const Locations& locations);
/// The walls of such a picture.
[[nodiscard]] Result<FloorPlan> readFloorPlan(const std::string& picture, const FloorPlanOptions& options,
                                              const Locations& locations);

/// Why an arena cannot have this name; empty if it can.
[[nodiscard]] std::string arenaNameFault(const std::string& name);

/// Writes an arena and an experiment with a robot in it into a new folder below `parent`: Office becomes office/office.sim and
/// office/office_drive.sim. `height`: of the walls, m. Fails, and writes nothing, if the name cannot be a config's, if that folder exists, or
/// if it cannot be written.
[[nodiscard]] Result<NewArena> makePlanArena(const std::string& name, const FloorPlan& plan, double height,
                                             const std::string& picture, const std::string& parent);
/// The same with obstacles in a room.
[[nodiscard]] Result<NewArena> makeObstacleArena(const std::string& name, const ObstacleField& field, const std::string& parent);
/// The same with the walls of a room or a maze. `comment`: what it is, for the text.
[[nodiscard]] Result<NewArena> makeRoomArena(const std::string& name, const RoomPlan& plan, const std::string& comment,
                                             const std::string& parent);
/// The same with a ground of a grey picture, which is copied into the folder. `size`: along x, along y, height of white, m.
[[nodiscard]] Result<NewArena> makeHeightsArena(const std::string& name, const std::string& picture,
                                                const std::array<double, 3>& size, const std::string& parent,
                                                const Locations& locations);

} // namespace trundle
