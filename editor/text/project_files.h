#pragma once
// Files that a text may name: those below the folders where they are looked for, as they would be written there.

#include <string>
#include <vector>

namespace trundle {

struct FileFolders {
    std::vector<std::string> texts;   ///< for #import, after the text's own folder and the project's
    std::vector<std::string> assets;  ///< for textures and meshes
    std::vector<std::string> modules; ///< for #loadModule
};

/// Paths relative to the first folder that leads to them, in alphabetical order, each file once. `endings` without the dot.
[[nodiscard]] std::vector<std::string> filesBelow(const std::vector<std::string>& folders,
                                                  const std::vector<std::string>& endings);
/// Modules as #loadModule names them: "controllers/linear_motion".
[[nodiscard]] std::vector<std::string> modulesBelow(const std::vector<std::string>& folders);

} // namespace trundle
