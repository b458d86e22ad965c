#pragma once
// `trundle-cli new arena`: a floor plan, an obstacle field, a room, a maze or a height map as options, and what is printed.

#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/arena_files.h"
#include "cli/exit_code.h"

namespace trundle {

struct ArenaArguments {
    std::string picture; ///< empty: obstacles
    FloorPlanOptions plan;
    std::optional<double> wallHeight, wallThickness; ///< m
    ObstacleField field;
    std::vector<double> roomSize; ///< m; empty: no room
    std::string doorSide = "none";
    RoomOptions room;
    std::vector<int> mazeSize; ///< rows, columns; empty: no maze
    MazeOptions maze;
    std::string heights; ///< a grey picture; empty: none
    std::vector<double> heightsSize{10, 10, 1};
};

void addArenaOptions(CLI::App& command, ArenaArguments& arguments);
/// After the command line is read: refuses options that have no effect on the arena asked for. Throws CLI::ValidationError.
void checkArenaOptions(const CLI::App& command);
[[nodiscard]] ExitCode makeNewArena(const ArenaArguments& arguments, const std::string& name, const std::string& parent,
                                    const Locations& locations);

} // namespace trundle
