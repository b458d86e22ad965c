#include "base/platform/user_folder.h"

#include <array>
#include <cstdlib>
#include <filesystem>

#include <pwd.h>
#include <unistd.h>

namespace trundle {

std::string homeFolder() {
    if (const char* home = std::getenv("HOME"); home && home[0] == '/') return home;
    std::array<char, 16384> words{};
    passwd entry{}, *found = nullptr;
    if (::getpwuid_r(::geteuid(), &entry, words.data(), words.size(), &found) != 0 || !found) return {};
    return found->pw_dir && found->pw_dir[0] == '/' ? found->pw_dir : "";
}

const std::string& privateTemporaryFolder() {
    static const std::string folder = [] {
        std::error_code none;
        std::string path = (std::filesystem::temp_directory_path(none) / "trundle-XXXXXX").string();
        return ::mkdtemp(path.data()) ? path : std::string();
    }();
    return folder;
}

} // namespace trundle
