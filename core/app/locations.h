#pragma once
#include <string>

namespace trundle {

/// Paths of the program's own files, derived from the path of its binary.
struct Locations {
    std::string configs;    ///< shipped experiments, robots, arenas
    std::string resources;  ///< textures and meshes
    std::string modules;    ///< controllers and components shipped with the program; always trusted
    std::string meshReader; ///< helper program that reads foreign mesh and image formats
    std::string host;       ///< helper program that runs controllers
    std::string templates;  ///< of modules
    std::string sdkPackage; ///< where CMake finds the package TrundleSdk
    std::string python;     ///< the Python package for controllers
};

[[nodiscard]] Locations findLocations();

} // namespace trundle
