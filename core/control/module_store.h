#pragma once
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <trundle/abi.h>

#include "base/call_monitor.h"
#include "base/diagnostic.h"
#include "base/platform/dynamic_library.h"
#include "base/result.h"
#include "model/experiment_spec.h"
#include "schema/kind.h"
#include "schema/registry.h"

namespace trundle {

/// A loaded module.
struct LoadedModule {
    std::string library;
    std::vector<DynamicLibrary> beside; ///< libraries from the module's own folder that it depends on
    DynamicLibrary code;
    const TrundleModule* descriptor = nullptr;
    const CallTarget* target = nullptr;
    std::vector<Kind> kinds;
};

/// The libraries of one run. Must outlive every controller and device created from them.
class ModuleStore {
public:
    /// `calls` records which module is being loaded or unloaded, and which library provides each kind.
    explicit ModuleStore(std::shared_ptr<CallMonitor> calls = std::make_shared<CallMonitor>()) : m_calls(std::move(calls)) {}
    ~ModuleStore();
    ModuleStore(const ModuleStore&) = delete;
    ModuleStore& operator=(const ModuleStore&) = delete;

    /// Checks the file, loads a copy of it from memory, so that the file can be rebuilt meanwhile, and checks its descriptor. A
    /// second call returns the same module.
    [[nodiscard]] Result<const LoadedModule*> load(const std::string& library);
    [[nodiscard]] Result<std::vector<Kind>> loadKinds(const std::string& library); ///< the same; returns its kinds
    /// The module that provides a kind with this role (TRUNDLE_CONTROLLER, TRUNDLE_DEVICE); nullptr: none.
    [[nodiscard]] const LoadedModule* owner(std::string_view kind, std::uint32_t role) const;
    [[nodiscard]] const TrundleKind* find(std::string_view kind, std::uint32_t role) const;

private:
    [[nodiscard]] Status checkNames(const LoadedModule& module) const;
    std::shared_ptr<CallMonitor> m_calls;
    std::vector<std::unique_ptr<LoadedModule>> m_modules;
};

/// Loads a module, in this process or another, and returns its kinds.
using ModuleLoader = std::function<Result<std::vector<Kind>>(const std::string& library)>;

/// Loads the modules of an experiment. An error is reported at the #loadModule of a module that cannot be used or whose kinds
/// differ from those in `registry`, with which the text was checked. If only the help texts of the description file are outdated,
/// the result is a warning (E412).
void loadModules(const ExperimentSpec& experiment, const Registry& registry, const ModuleLoader& load, Diagnostics& diagnostics);
/// The same into a store, in this process.
void loadModules(const ExperimentSpec& experiment, const Registry& registry, ModuleStore& store, Diagnostics& diagnostics);

/// Whether the description file of any module of the experiment now differs from `registry`, which was filled from it. Also if a module
/// was not found or did not load: what was wrong with it may have been corrected.
[[nodiscard]] bool descriptionChanged(const ExperimentSpec& experiment, const Registry& registry);

/// Loads `library` (its code runs) and writes its description to `out`. Used by `trundle-cli describe --module`.
[[nodiscard]] Status writeKindsJson(const std::string& library, const std::string& out,
                                    std::shared_ptr<CallMonitor> calls = std::make_shared<CallMonitor>());

} // namespace trundle
