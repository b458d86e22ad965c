#pragma once
#include <string>
#include <vector>

namespace trundle {

/// Files that are no texts, that the texts name, and that would not be found from another place.
struct Companions {
    std::vector<std::string> files, modules; ///< absolute: meshes and pictures; libraries
    [[nodiscard]] bool empty() const { return files.empty() && modules.empty(); }
};
/// Name: the text gives the whole path of the module where it is, and it is not copied.
enum class ModuleCopies { Make, Name };

} // namespace trundle
