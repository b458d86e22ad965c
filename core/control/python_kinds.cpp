// The cache has one file for each Python file, named by a hash of its path: the description as of a library, with the sources that it
// was made from and their sizes and times.
#include "control/python_kinds.h"

#include <cstdlib>
#include <filesystem>

#include <nlohmann/json.hpp>

#include "base/platform/atomic_file.h"
#include "base/platform/read_file.h"
#include "base/platform/user_folder.h"
#include "base/rng.h"
#include "control/kinds_json.h"

namespace trundle {
namespace {

namespace fs = std::filesystem;
constexpr std::uint64_t kMostCacheBytes = 16u << 20;

/// $XDG_CACHE_HOME/trundle/python, or below ~/.cache; empty if the user has no home folder.
fs::path cacheFolder() {
    const char* const given = std::getenv("XDG_CACHE_HOME");
    if (given && fs::path(given).is_absolute()) return fs::path(given) / "trundle" / "python";
    const std::string home = homeFolder();
    return home.empty() ? fs::path() : fs::path(home) / ".cache" / "trundle" / "python";
}

fs::path cacheFile(const std::string& file) {
    const fs::path folder = cacheFolder();
    return folder.empty() ? fs::path() : folder / (std::to_string(fnv1a64(file)) + ".json");
}

/// Throws if the sources have another form.
bool isCurrent(const nlohmann::json& sources, const std::string& file) {
    bool isOfFile = false;
    for (const nlohmann::json& source : sources) {
        const auto path = source.at(0).get<std::string>();
        const auto stamp = regularFileStamp(path);
        if (!stamp || stamp.value().size != source.at(1).get<std::uint64_t>() ||
            stamp.value().modifiedNs != source.at(2).get<std::int64_t>())
            return false;
        isOfFile = isOfFile || path == file;
    }
    return isOfFile;
}

} // namespace

std::optional<std::vector<Kind>> cachedPythonKinds(const std::string& file) {
    const fs::path cache = cacheFile(file);
    std::error_code none;
    if (cache.empty() || !fs::exists(cache, none)) return {};
    const auto text = readRegularFile(cache.string(), kMostCacheBytes);
    if (!text) return {};
    try { // the JSON library reports errors by exceptions
        const auto json = nlohmann::json::parse(text.value());
        if (json.at("sdk") != TRUNDLE_SDK_VERSION || !isCurrent(json.at("sources"), file)) return {};
    } catch (const std::exception&) { return {}; }
    auto kinds = kindsFromJson(text.value(), file);
    if (!kinds) return {};
    return std::move(kinds).value();
}

void cachePythonKinds(const std::string& file, const std::string& json) {
    const fs::path cache = cacheFile(file);
    if (cache.empty()) return;
    std::error_code none;
    fs::create_directories(cache.parent_path(), none);
    (void)writeFileAtomically(cache.string(), json);
}

} // namespace trundle
