#pragma once
// Finds the modules of a project, registers their kinds, and suggests modules for unknown kinds.
#include "model/experiment_spec.h"
#include "project/loading/loader.h"
#include "project/loading/sources.h"
#include "schema/registry.h"

namespace trundle {

struct LoadedProject;

/// Whether a module is unavailable although the text is correct: it can be viewed and edited, its blocks kept unparsed, but it
/// does not run without its controllers.
[[nodiscard]] bool isUnavailableModule(Code code);
/// Whether all modules are available, by the diagnostics of their project.
[[nodiscard]] bool hasAllModules(const Diagnostics& diagnostics);

/// Queries the catalog once for each module and adds its kinds to the registry.
struct FoundModules {
    std::vector<ModuleSpec> modules;
    bool open = false; ///< the kinds of at least one module are unknown
};
[[nodiscard]] FoundModules findModules(const std::vector<ModuleReference>& references, ModuleCatalog& catalog, Registry& registry,
                                       Diagnostics& diagnostics);

/// Adds fixes to unknown kinds that a module shipped with the program provides: its name and the line that loads it.
void offerModules(const LoadedProject& loaded, ModuleCatalog& catalog, std::vector<Diagnostic>& diagnostics);

} // namespace trundle
