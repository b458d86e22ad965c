#include "project/state_folder.h"

#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "base/platform/locked_file.h"

namespace trundle {

namespace fs = std::filesystem;

namespace {

/// FNV-1a, 64 bit: a short name that is the same in every run.
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
    // A relative path in either variable is no place: it would wander with the working folder.
    if (const char* state = std::getenv("XDG_STATE_HOME"); state && fs::path(state).is_absolute())
        return (fs::path(state) / "trundle").string();
    if (const char* home = std::getenv("HOME"); home && fs::path(home).is_absolute())
        return (fs::path(home) / ".local" / "state" / "trundle").string();
    std::error_code none;
    return (fs::temp_directory_path(none) / "trundle-state").string();
}

std::vector<std::string> workFolders(const std::string& projectFolder) {
    std::vector<std::string> folders;
    if (isMarked(projectFolder)) folders.push_back((fs::path(projectFolder) / ".trundle").string());
    folders.push_back(userStateFolder() + "/projects/" + shortName(projectFolder));
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
