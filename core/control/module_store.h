#pragma once
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <trundle/abi.h>

#include "base/diagnostic.h"
#include "base/platform/dynamic_library.h"
#include "base/result.h"
#include "model/experiment_spec.h"
#include "schema/kind.h"

namespace trundle {

/// An opened module.
struct LoadedModule {
    std::string library;
    DynamicLibrary code;
    const TrundleModule* descriptor = nullptr;
    std::vector<Kind> kinds;
};

/// The libraries of one run. It must outlive every controller and device made from them.
class ModuleStore {
public:
    /// Checks the file, opens it, checks its descriptor. The second time gives the same module.
    [[nodiscard]] Result<const LoadedModule*> load(const std::string& library);
    /// The module that brings a kind of this role (TRUNDLE_CONTROLLER, TRUNDLE_DEVICE); nullptr: none.
    [[nodiscard]] const LoadedModule* owner(std::string_view kind, std::uint32_t role) const;
    [[nodiscard]] const TrundleKind* find(std::string_view kind, std::uint32_t role) const;

private:
    [[nodiscard]] Status checkNames(const LoadedModule& module) const;
    std::vector<std::unique_ptr<LoadedModule>> m_modules;
};

/// Loads the modules of an experiment. What cannot be used is an error at its #loadModule; a description file that no longer fits
/// is a warning there (E412).
void loadModules(const ExperimentSpec& experiment, ModuleStore& store, Diagnostics& diagnostics);

} // namespace trundle
