#include "project/loading/import_path.h"

#include <filesystem>

#include "project/loading/search.h"

namespace trundle {

std::optional<std::string> pathBelow(const std::string& absolute, std::span<const std::string> folders) {
    namespace fs = std::filesystem;
    // Only the folder is resolved: the file may be a link to another folder, or its ending may be omitted.
    const fs::path file = fs::path(canonicalPath(fs::path(absolute).parent_path().string())) / fs::path(absolute).filename();
    for (const std::string& folder : folders) {
        if (folder.empty()) continue;
        const fs::path below = file.lexically_relative(canonicalPath(folder));
        if (!below.empty() && *below.begin() != ".." && below != ".") return below.generic_string();
    }
    return std::nullopt;
}

} // namespace trundle
