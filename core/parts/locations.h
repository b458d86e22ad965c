#pragma once
#include <string>

namespace trundle {

/// Where the program's own files are, worked out from where its binary is.
struct Locations {
    std::string configs;    ///< shipped experiments, robots, arenas
    std::string resources;  ///< textures and meshes
    std::string modules;    ///< controllers and components that come with the program; these are trusted
    std::string meshReader; ///< the helper program that reads foreign meshes and pictures
};

[[nodiscard]] Locations findLocations();

} // namespace trundle
