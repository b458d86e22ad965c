#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <unistd.h>

#include "devices/builtin.h"
#include "fuzz/targets.h"
#include "model/kinds/model_kinds.h"
#include "run/logs/log_kinds.h"

namespace trundle::fuzz {
namespace {

class NoModules final : public ModuleCatalog {
public:
    Result<ModuleListing> find(const std::string& written, const std::string&) override {
        return Error{Code::ModuleNotFound, "there is no module " + written};
    }
};

class NoMeshes final : public MeshSource {
public:
    Result<std::shared_ptr<const TriangleMesh>> mesh(const std::string& path) override {
        return Error{Code::MeshUnreadable, "no meshes here: " + path};
    }
    Result<std::shared_ptr<const HeightMap>> heightMap(const std::string& path) override {
        return Error{Code::MeshUnreadable, "no pictures here: " + path};
    }
};

/// A temporary folder of this process, on a memory file system where there is one.
const std::filesystem::path& scratch() {
    static const std::filesystem::path& folder = *new std::filesystem::path([] { // lives until after the handler below
        const char* const memory = "/dev/shm";
        const std::filesystem::path base =
            std::filesystem::is_directory(memory) ? std::filesystem::path(memory) : std::filesystem::temp_directory_path();
        const std::filesystem::path own = base / ("trundle-fuzz-" + std::to_string(::getpid()));
        std::filesystem::create_directories(own);
        std::atexit([] {
            std::error_code none;
            std::filesystem::remove_all(scratch(), none);
        });
        return own;
    }());
    return folder;
}

} // namespace

void require(bool holds) {
    if (!holds) std::abort();
}

std::shared_ptr<const Registry> builtInKinds() {
    static const std::shared_ptr<const Registry> kinds = [] {
        auto registry = std::make_shared<Registry>();
        addModelKinds(*registry);
        require(addDeviceKinds(*registry).ok());
        require(addLogKinds(*registry).ok());
        return registry;
    }();
    return kinds;
}

std::shared_ptr<const LoadedProject> open(std::span<const std::uint8_t> bytes) {
    const std::filesystem::path file = scratch() / "fuzz.sim";
    std::ofstream(file, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    NoModules modules;
    NoMeshes meshes;
    Project project(builtInKinds(), modules, meshes, {});
    auto loaded = project.open(file.string());
    require(loaded.ok());
    return std::move(loaded).value();
}

} // namespace trundle::fuzz
