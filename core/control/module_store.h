#pragma once
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

/// An opened module.
struct LoadedModule {
    std::string library;
    std::vector<DynamicLibrary> beside; ///< libraries that the code needs, from the module's own folder
    DynamicLibrary code;
    const TrundleModule* descriptor = nullptr;
    const CallTarget* target = nullptr;
    std::vector<Kind> kinds;
};

/// The libraries of one run. It must outlive every controller and device made from them.
class ModuleStore {
public:
    /// `calls` hears which module is being loaded or unloaded, and from where each kind comes.
    explicit ModuleStore(std::shared_ptr<CallMonitor> calls = std::make_shared<CallMonitor>()) : m_calls(std::move(calls)) {}
    ~ModuleStore();
    ModuleStore(const ModuleStore&) = delete;
    ModuleStore& operator=(const ModuleStore&) = delete;

    /// Checks the file, opens a copy of it in memory, so that the file may be built anew meanwhile, and checks its descriptor. The
    /// second time gives the same module.
    [[nodiscard]] Result<const LoadedModule*> load(const std::string& library);
    /// The module that brings a kind of this role (TRUNDLE_CONTROLLER, TRUNDLE_DEVICE); nullptr: none.
    [[nodiscard]] const LoadedModule* owner(std::string_view kind, std::uint32_t role) const;
    [[nodiscard]] const TrundleKind* find(std::string_view kind, std::uint32_t role) const;

private:
    [[nodiscard]] Status checkNames(const LoadedModule& module) const;
    std::shared_ptr<CallMonitor> m_calls;
    std::vector<std::unique_ptr<LoadedModule>> m_modules;
};

/// Loads the modules of an experiment. What cannot be used is an error at its #loadModule, and so is a module whose kinds are others
/// than those in `registry`, which the text was checked with. A description file where only words are old is a warning (E412).
void loadModules(const ExperimentSpec& experiment, const Registry& registry, ModuleStore& store, Diagnostics& diagnostics);

/// Whether the description file of a module of the experiment says something else now than `registry`, which was filled from it.
[[nodiscard]] bool describedAnew(const ExperimentSpec& experiment, const Registry& registry);

} // namespace trundle
