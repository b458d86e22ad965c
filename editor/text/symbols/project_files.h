#pragma once
// Lists the files in the search folders, by the paths that a text would use for them.

#include <string>
#include <vector>

namespace trundle {

struct FileFolders {
    std::vector<std::string> texts;   ///< for #import, in addition to the text's own folder and the project's
    std::vector<std::string> assets;  ///< for textures and meshes
    std::vector<std::string> modules; ///< for #loadModule
};

/// Paths relative to the first folder that contains the file, in alphabetical order, without duplicates. `endings` without the
/// dot.
[[nodiscard]] std::vector<std::string> filesBelow(const std::vector<std::string>& folders,
                                                  const std::vector<std::string>& endings);
/// Modules by the names that #loadModule uses: "controllers/linear_motion".
[[nodiscard]] std::vector<std::string> modulesBelow(const std::vector<std::string>& folders);

} // namespace trundle
