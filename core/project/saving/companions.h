#pragma once

#include <string>
#include <vector>

namespace trundle {

/// Files other than texts that the texts refer to by a path that would not resolve from the new location; saveAs() copies
/// them.
struct Companions {
    std::vector<std::string> files, modules; ///< absolute; files: meshes and images; modules: shared libraries
    [[nodiscard]] bool empty() const { return files.empty() && modules.empty(); }
};
/// Make: modules are copied. Name: the text gets the module's absolute path and nothing is copied.
enum class ModuleCopies { Make, Name };

} // namespace trundle
