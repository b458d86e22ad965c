#pragma once
// Building modules from their sources: where the sources are, and what CMake is called with.

#include <string>
#include <vector>

#include "app/locations.h"

namespace trundle {

/// The folder with the CMakeLists.txt of a source or of a built library: the nearest one above the file that is inside `project`, or is
/// that folder. Empty: none found. Absolute paths.
[[nodiscard]] std::string moduleFolderOf(const std::string& file, const std::string& project);

/// The sources in C++, and CMakeLists.txt, in the moduleFolderOf() a built library, by name. None if it is not in `project`.
[[nodiscard]] std::vector<std::string> sourcesOfModule(const std::string& library, const std::string& project);

/// One call of cmake, by its arguments.
using BuildStep = std::vector<std::string>;

/// Configures the module of a folder in its subfolder `build`, unless that is done, and builds it. CMake configures again by itself where
/// CMakeLists.txt has changed.
[[nodiscard]] std::vector<BuildStep> buildSteps(const std::string& folder, const Locations& locations);

} // namespace trundle
