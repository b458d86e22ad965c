#include "app/locations.h"

#include <filesystem>

#include "base/platform/program_path.h"

namespace trundle {

namespace {

/// The installed folder beside the program, or the one in the source tree if the program runs from its build folder.
std::string sharedFolder(const std::filesystem::path& prefix, const char* name, const char* inSource) {
    std::error_code none;
    const std::filesystem::path installed = prefix / "share" / "trundle" / name;
    return std::filesystem::is_directory(installed, none) ? installed.string() : inSource;
}

/// An installed package is found from the prefix.
std::string sdkPackage(const std::filesystem::path& prefix) {
    std::error_code none;
    const std::filesystem::path built = prefix / "sdk";
    return (std::filesystem::is_directory(built, none) ? built : prefix).string();
}

} // namespace

Locations findLocations() {
    const std::filesystem::path bin = programFolder();
    const std::filesystem::path prefix = bin.parent_path();
    return {sharedFolder(prefix, "configs", TRUNDLE_SOURCE_CONFIGS),
            sharedFolder(prefix, "resources", TRUNDLE_SOURCE_RESOURCES),
            (prefix / "lib" / "trundle").string(),
            (prefix / "bin" / "trundle-meshreader").string(),
            (prefix / "bin" / "trundle-host").string(),
            sharedFolder(prefix, "template", TRUNDLE_SOURCE_TEMPLATES),
            sdkPackage(prefix),
            sharedFolder(prefix, "python", TRUNDLE_SOURCE_PYTHON)};
}

} // namespace trundle
