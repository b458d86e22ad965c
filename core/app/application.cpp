#include "app/application.h"

#include <algorithm>
#include <filesystem>
#include <regex>
#include <stdexcept>

#include <trundle/abi.h>

#include "app/render_library.h"
#include "assets/asset_reader.h"
#include "base/platform/read_file.h"
#include "control/directory_catalog.h"
#include "control/host/host_pool.h"
#include "control/host/python_describer.h"
#include "control/host/python_devices.h"
#include "control/in_process_backend.h"
#include "control/kinds_json.h"
#include "control/module_kinds.h"
#include "control/module_store.h"
#include "control/python_kinds.h"
#include "devices/builtin.h"
#include "model/kinds/model_kinds.h"
#include "run/logs/log_kinds.h"

namespace trundle {
namespace {

namespace fs = std::filesystem;

/// Connects asset reading to project loading: the two libraries do not depend on each other.
class AssetMeshes final : public MeshSource {
public:
    explicit AssetMeshes(AssetReader& reader) : m_reader(reader) {}
    Result<std::shared_ptr<const TriangleMesh>> mesh(const std::string& path) override { return m_reader.mesh(path); }
    Result<std::shared_ptr<const HeightMap>> heightMap(const std::string& path) override { return m_reader.heightMap(path); }
    Result<std::shared_ptr<const Raster>> picture(const std::string& path) override { return m_reader.picture(path); }

private:
    AssetReader& m_reader;
};

/// Returns only meshes and pictures that the cache already holds; everything else is reported as pending.
class CachedMeshes final : public MeshSource {
public:
    explicit CachedMeshes(AssetReader& reader) : m_reader(reader) {}
    Result<std::shared_ptr<const TriangleMesh>> mesh(const std::string& path) override {
        return orLater(m_reader.cachedMesh(path), path);
    }
    Result<std::shared_ptr<const HeightMap>> heightMap(const std::string& path) override {
        return orLater(m_reader.cachedHeightMap(path), path);
    }
    Result<std::shared_ptr<const Raster>> picture(const std::string& path) override {
        return orLater(m_reader.cachedPicture(path), path);
    }
    bool pending() const override { return m_pending; }

private:
    template <class Asset> Result<Asset> orLater(std::optional<Result<Asset>> kept, const std::string& path) {
        if (kept) return std::move(*kept);
        m_pending = true;
        return Error{Code::MeshUnreadable, path + " is being read"};
    }

    AssetReader& m_reader;
    bool m_pending = false;
};

void mustHold(const Status& status) {
    if (!status) throw std::logic_error(status.error().message); // two built-in kinds with the same name: a programming error
}

std::shared_ptr<const Registry> builtInKinds() {
    auto registry = std::make_shared<Registry>();
    addModelKinds(*registry);
    mustHold(addDeviceKinds(*registry));
    mustHold(addLogKinds(*registry));
    return registry;
}

/// The code of modules that a run uses, in this process and in host processes.
struct RunCode {
    RunCode(const LoadedProject& loaded, const HostPrograms& programs, const RunOptions& options, Isolation isolation)
        : experiment(loaded.experiment), store(options.calls), hosts(programs, loaded.experiment, options.calls, isolation,
                                                                     [&loaded](const std::string& kind) {
                                                                         const Kind* found = loaded.registry->find(kind);
                                                                         return found ? found->module : std::string();
                                                                     }),
          devices(programs, loaded.experiment->settings.seed, options.calls) {}

    void setConsole(const RunOptions& options) {
        if (options.console)
            hosts.setConsole([console = options.console, calls = options.calls](const std::string& text) {
                console(calls->time(), {}, TRUNDLE_WARNING, text);
            });
    }
    Result<std::unique_ptr<ControllerBackend>> makeBackend(const ControllerRequest& request) {
        if (!request.library.empty() && !hosts.addLater(request.robot, request.controller, request.library))
            if (const auto loaded = store.load(request.library); !loaded) return loaded.error();
        if (hosts.has(*request.robot, request.controller)) return hosts.makeBackend(*request.robot, request.controller);
        return makeInProcessBackend(*request.robot, request.controller, request.settings, store);
    }
    /// Code of a module runs in this process only if a device or a controller needs it here.
    Result<std::vector<Kind>> load(const std::string& library, const Registry& registry) {
        const bool needed = hasDeviceOf(library, registry);
        if (isPythonModule(library) && needed) return devices.load(library);
        return hosts.hasOnly(library) && !needed ? hosts.load(library) : store.loadKinds(library);
    }
    [[nodiscard]] DeviceKind deviceKind(const std::string& kind) {
        if (const TrundleKind* builtIn = findBuiltInDevice(kind)) return builtIn;
        if (const TrundleKind* python = devices.find(kind)) return {python, [this, kind] { return devices.create(kind); }};
        return store.find(kind, TRUNDLE_DEVICE);
    }
    [[nodiscard]] bool hasDeviceOf(const std::string& library, const Registry& registry) const {
        const auto isOfLibrary = [&](const ComponentSpec& device) {
            const Kind* kind = registry.find(device.kind);
            return kind && kind->module == library;
        };
        return std::ranges::any_of(
            experiment->robots, [&](const RobotSpec& robot) { return std::ranges::any_of(robot.config->devices, isOfLibrary); });
    }

    std::shared_ptr<const ExperimentSpec> experiment;
    ModuleStore store;
    HostPool hosts;
    PythonDevices devices;
};

class TrundleApplication final : public Application {
public:
    TrundleApplication(Locations locations, Isolation isolation)
        : m_locations(std::move(locations)), m_isolation(isolation), m_builtIn(builtInKinds()), m_assets(m_locations.meshReader),
          m_python({m_locations.host, m_locations.python}) {}

    std::shared_ptr<const Registry> builtIn() const override { return m_builtIn; }
    Isolation isolation() const override { return m_isolation; }
    const Locations& locations() const override { return m_locations; }
    std::vector<Kind> moduleKinds(const OpenOptions& options) const override { return readModules(options).kinds; }
    std::vector<Error> moduleFaults(const OpenOptions& options) const override { return readModules(options).faults; }
    Result<std::shared_ptr<const LoadedProject>> open(const std::string& path, const OpenOptions& options) override;
    std::unique_ptr<Runner> makeRunner(const LoadedProject& loaded, RunOptions options, Diagnostics& diagnostics) override;

private:
    struct ReadModules {
        std::vector<Kind> kinds;
        std::vector<Error> faults;
    };
    ReadModules readModules(const OpenOptions& options) const;
    void addPythonKinds(const std::vector<std::string>& folders, ReadModules& modules) const;

    Locations m_locations;
    Isolation m_isolation;
    std::shared_ptr<const Registry> m_builtIn;
    AssetReader m_assets;
    mutable PythonDescriber m_python;
};

TrundleApplication::ReadModules TrundleApplication::readModules(const OpenOptions& options) const {
    std::vector<std::string> descriptions;
    std::vector<std::string> folders = options.modules;
    folders.push_back(m_locations.modules);
    for (const std::string& folder : folders) {
        std::error_code none;
        for (fs::recursive_directory_iterator at(folder, none), end; !none && at != end; at.increment(none))
            if (at->path().string().ends_with(".kinds.json")) descriptions.push_back(at->path().string());
    }
    std::ranges::sort(descriptions);
    ReadModules modules;
    for (const std::string& path : descriptions) {
        const Result<std::string> text = readRegularFile(path);
        Result<std::vector<Kind>> read =
            text ? kindsFromJson(text.value(), path.substr(0, path.size() - std::string_view(".kinds.json").size()))
                 : text.error();
        if (!read) {
            modules.faults.push_back(read.error());
            continue;
        }
        for (Kind& kind : std::move(read).value()) modules.kinds.push_back(std::move(kind));
    }
    addPythonKinds(options.modules, modules); // those that come with the program have the kinds of its libraries
    return modules;
}

/// Of the files that import the package; others may be programs. A kind that a library has too is that of the library.
void TrundleApplication::addPythonKinds(const std::vector<std::string>& folders, ReadModules& modules) const {
    static const std::regex import("(^|\\n)[ \\t]*(import|from)[ \\t]+trundle\\b");
    std::vector<std::string> files;
    for (const std::string& folder : folders) {
        std::error_code none;
        for (fs::recursive_directory_iterator at(folder, none), end; !none && at != end; at.increment(none))
            if (isPythonModule(at->path().string())) files.push_back(at->path().string());
    }
    std::ranges::sort(files);
    for (const std::string& file : files) {
        const Result<std::string> text = readRegularFile(file);
        if (!text || !std::regex_search(text.value(), import)) continue;
        Result<std::vector<Kind>> read = m_python.kinds(file);
        if (!read) {
            modules.faults.push_back(read.error());
            continue;
        }
        for (Kind& kind : std::move(read).value())
            if (std::ranges::find(modules.kinds, kind.name, &Kind::name) == modules.kinds.end())
                modules.kinds.push_back(std::move(kind));
    }
}

Result<std::shared_ptr<const LoadedProject>> TrundleApplication::open(const std::string& path, const OpenOptions& options) {
    DirectoryCatalog catalog({options.modules, m_locations.modules, options.trusted, options.trust},
                             [this](const std::string& file) { return m_python.kinds(file); });
    AssetMeshes all(m_assets);
    CachedMeshes kept(m_assets);
    MeshSource& meshes = options.meshesLater ? static_cast<MeshSource&>(kept) : all;
    Project project(m_builtIn, catalog, meshes,
                    {options.includes, m_locations.configs, m_locations.resources, options.sets, options.texts, options.previous,
                     options.shownFromProject});
    return project.open(path);
}

std::unique_ptr<Runner> TrundleApplication::makeRunner(const LoadedProject& loaded, RunOptions options,
                                                       Diagnostics& diagnostics) {
    if (!options.calls) options.calls = std::make_shared<CallMonitor>();
    const HostPrograms programs{m_locations.host, m_locations.python};
    const auto code = std::make_shared<RunCode>(loaded, programs, options, m_isolation); // per run: the next one loads rebuilt libraries
    code->setConsole(options);
    options.keeps = code;
    loadModules(*loaded.experiment, *loaded.registry,
                [&](const std::string& library) { return code->load(library, *loaded.registry); }, diagnostics);
    if (diagnostics.hasErrors()) return nullptr;
    const DeviceCode devices = [&code = *code](const std::string& kind) { return code.deviceKind(kind); };
    const BackendFactory backends = [&code = *code](const ControllerRequest& request) { return code.makeBackend(request); };
    const auto world = std::make_shared<const World*>(nullptr); // set once the world exists
    if (!options.pictures) {
        const auto warn = [world, console = options.console](const std::string& line) {
            if (console) console(*world ? (*world)->time() : 0, {}, TRUNDLE_WARNING, line);
        };
        options.pictures = [folder = m_locations.modules, warn](const ExperimentSpec& experiment, const SignalLayout& layout) {
            return openImageSource(folder, experiment, layout, {LookChoice::Automatic, warn, true});
        };
    }
    std::unique_ptr<Runner> runner = Runner::create(loaded.experiment, devices, backends, std::move(options), diagnostics);
    if (runner) *world = &runner->world();
    return runner;
}

} // namespace

std::unique_ptr<Application> makeApplication(Locations locations, Isolation isolation) {
    return std::make_unique<TrundleApplication>(std::move(locations), isolation);
}

} // namespace trundle
