#pragma once
// `trundle-cli new arena`: a floor plan or an obstacle field as options, and what is printed.

#include <string>

#include <CLI/CLI.hpp>

#include "app/arena_files.h"
#include "cli/exit_code.h"

namespace trundle {

struct ArenaArguments {
    std::string picture; ///< empty: obstacles
    FloorPlanOptions plan;
    double wallHeight = 0.5; ///< m
    ObstacleField field;
};

void addArenaOptions(CLI::App& command, ArenaArguments& arguments);
[[nodiscard]] ExitCode makeNewArena(const ArenaArguments& arguments, const std::string& name, const std::string& parent,
                                    const Locations& locations);

} // namespace trundle
