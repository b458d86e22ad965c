#include "app/module_build.h"

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <thread>

namespace trundle {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kSourceExtensions[] = {".cpp", ".cc", ".h", ".hpp"};

} // namespace

std::string moduleFolderOf(const std::string& file, const std::string& project) {
    std::error_code none;
    const fs::path top = fs::path(project).lexically_normal();
    for (fs::path folder = fs::path(file).lexically_normal().parent_path(); !folder.empty(); folder = folder.parent_path()) {
        const bool isInside = std::ranges::mismatch(top, folder).in1 == top.end();
        if (!isInside) return {};
        if (fs::is_regular_file(folder / "CMakeLists.txt", none) && !fs::exists(folder / "CMakeCache.txt", none))
            return folder.string();
    }
    return {};
}

std::vector<std::string> sourcesOfModule(const std::string& library, const std::string& project) {
    std::vector<std::string> sources;
    const std::string folder = moduleFolderOf(library, project);
    if (folder.empty()) return sources;
    std::error_code none;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, none)) {
        const std::string extension = entry.path().extension().string();
        const bool isSource = std::ranges::count(kSourceExtensions, extension) > 0 || entry.path().filename() == "CMakeLists.txt";
        if (isSource && entry.is_regular_file(none)) sources.push_back(entry.path().string());
    }
    std::ranges::sort(sources);
    return sources;
}

std::vector<BuildStep> buildSteps(const std::string& folder, const Locations& locations) {
    const std::string build = (fs::path(folder) / "build").string();
    std::error_code none;
    // An interrupted configuration leaves a cache, but no rules.
    const bool isConfigured = fs::exists(fs::path(build) / "Makefile", none) || fs::exists(fs::path(build) / "build.ninja", none);
    std::vector<BuildStep> steps;
    if (!isConfigured)
        steps.push_back({"-S", folder, "-B", build, "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_PREFIX_PATH=" + locations.sdkPackage});
    steps.push_back({"--build", build, "--parallel", std::to_string(std::max(1u, std::thread::hardware_concurrency()))});
    return steps;
}

} // namespace trundle
