#include "project/journal/state_folder.h"

#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "base/platform/locked_file.h"
#include "base/platform/user_folder.h"

namespace trundle {

namespace fs = std::filesystem;

namespace {

/// FNV-1a, 64 bit: a short name that is stable across runs.
std::string shortName(const std::string& path) {
    std::uint64_t hash = 14695981039346656037u;
    for (const char letter : path) hash = (hash ^ static_cast<unsigned char>(letter)) * 1099511628211u;
    std::array<char, 17> text{};
    std::snprintf(text.data(), text.size(), "%016llx", static_cast<unsigned long long>(hash));
    return text.data();
}

bool isMarked(const fs::path& folder) {
    std::error_code none;
    return folder.filename() == "configs" || fs::is_directory(folder / ".trundle", none);
}

bool isLink(const fs::path& path) {
    std::error_code none;
    return fs::is_symlink(fs::symlink_status(path, none));
}

bool canWriteIn(const std::string& folder) {
    std::error_code failed;
    fs::create_directories(folder, failed);
    if (failed) return false;
    Result<std::optional<LockedFile>> probe = LockedFile::take(folder + "/probe");
    if (!probe) return false;
    if (probe.value()) probe.value()->remove();
    return true;
}

} // namespace

std::string userStateFolder() {
    // Relative paths are ignored: they would depend on the current folder.
    if (const char* state = std::getenv("XDG_STATE_HOME"); state && fs::path(state).is_absolute())
        return (fs::path(state) / "trundle").string();
    if (const std::string home = homeFolder(); !home.empty()) return home + "/.local/state/trundle";
    return privateTemporaryFolder() + "/trundle";
}

std::string projectStateFolder(const std::string& projectFolder) {
    return userStateFolder() + "/projects/" + shortName(projectFolder);
}

std::vector<std::string> workFolders(const std::string& projectFolder) {
    std::vector<std::string> folders;
    const fs::path own = fs::path(projectFolder) / ".trundle";
    if (isMarked(projectFolder) && !isLink(own)) folders.push_back(own.string());
    folders.push_back(projectStateFolder(projectFolder));
    return folders;
}

std::string makeWorkFolder(const std::string& projectFolder) {
    for (std::string& folder : workFolders(projectFolder))
        if (canWriteIn(folder)) return folder;
    return {};
}

void tidyWorkFolder(const std::string& folder) {
    const fs::path path(folder);
    std::error_code notEmpty;
    if (path.filename() != ".trundle" || path.parent_path().filename() == "configs") fs::remove(path, notEmpty);
}

} // namespace trundle
