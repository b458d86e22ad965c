#include "base/platform/program_path.h"

#include <filesystem>

namespace trundle {

std::string programPath() {
    std::error_code none;
    return std::filesystem::read_symlink("/proc/self/exe", none).string();
}

std::string programFolder() { return std::filesystem::path(programPath()).parent_path().string(); }

} // namespace trundle
