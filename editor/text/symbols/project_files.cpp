#include "editor/text/symbols/project_files.h"

#include <algorithm>
#include <filesystem>
#include <set>

namespace trundle {
namespace {

namespace fs = std::filesystem;
constexpr int kDeepest = 6;
constexpr std::size_t kMaxLookedAt = 20'000; ///< limit, since a project may be in a home folder

template <class Take> void eachFile(const std::string& folder, Take take) {
    std::error_code error;
    std::size_t looked = 0;
    for (fs::recursive_directory_iterator at(folder, fs::directory_options::skip_permission_denied, error), end;
         !error && at != end && looked < kMaxLookedAt; at.increment(error), ++looked) {
        std::error_code ignored;
        const std::string name = at->path().filename().string();
        if (at.depth() >= kDeepest || name.starts_with(".")) at.disable_recursion_pending();
        if (!name.starts_with(".") && at->is_regular_file(ignored)) take(at->path());
    }
}

} // namespace

std::vector<std::string> filesBelow(const std::vector<std::string>& folders, const std::vector<std::string>& endings) {
    std::set<std::string> names;
    std::set<fs::path> seen;
    for (const std::string& folder : folders) {
        if (folder.empty()) continue;
        eachFile(folder, [&](const fs::path& file) {
            const std::string extension = file.extension().string();
            const bool fits =
                std::any_of(endings.begin(), endings.end(), [&](const std::string& e) { return extension == "." + e; });
            std::error_code error;
            if (fits && seen.insert(fs::weakly_canonical(file, error)).second)
                names.insert(file.lexically_relative(folder).generic_string());
        });
    }
    return {names.begin(), names.end()};
}

std::vector<std::string> modulesBelow(const std::vector<std::string>& folders) {
    std::set<std::string> names;
    for (const std::string& folder : folders) {
        if (folder.empty()) continue;
        eachFile(folder, [&](const fs::path& file) {
            if (file.extension() != ".so") return;
            std::string name = file.stem().string();
            if (name.starts_with("lib")) name.erase(0, 3);
            names.insert((file.lexically_relative(folder).parent_path() / name).generic_string());
        });
    }
    return {names.begin(), names.end()};
}

} // namespace trundle
