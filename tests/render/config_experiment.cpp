#include "render/config_experiment.h"

#include "devices/builtin.h"
#include "model/kinds/model_kinds.h"
#include "project/loading/project.h"

namespace trundle {
namespace {

/// A catalog without modules: blocks of their kinds stay unresolved.
struct NoModules final : ModuleCatalog {
    Result<ModuleListing> find(const std::string&, const std::string&) override {
        return Error{Code::ModuleNotFound, "no modules here"};
    }
};
struct NoMeshes final : MeshSource {
    Result<std::shared_ptr<const TriangleMesh>> mesh(const std::string&) override {
        return Error{Code::MeshUnreadable, "no meshes here"};
    }
    Result<std::shared_ptr<const HeightMap>> heightMap(const std::string&) override {
        return Error{Code::MeshUnreadable, "no pictures here"};
    }
};

} // namespace

std::shared_ptr<const LoadedProject> readProject(const std::string& path) {
    auto registry = std::make_shared<Registry>();
    addModelKinds(*registry);
    if (!addDeviceKinds(*registry)) return nullptr;
    NoModules modules;
    NoMeshes meshes;
    ProjectOptions options;
    options.shippedConfigs = TRUNDLE_SOURCE_DIR "/configs";
    const auto loaded = Project(registry, modules, meshes, options).open(path);
    return loaded.ok() ? loaded.value() : nullptr;
}

std::shared_ptr<const ExperimentSpec> readExperiment(const std::string& path) {
    const auto loaded = readProject(path);
    return loaded ? loaded->experiment : nullptr;
}

} // namespace trundle
