#pragma once
#include "model/experiment_spec.h"
#include "project/loader.h"
#include "project/sources.h"
#include "schema/registry.h"

namespace trundle {

struct Loaded;

/// Asks the catalog about each module once and adds its kinds to the registry.
struct FoundModules {
    std::vector<ModuleSpec> modules;
    bool open = false; ///< the kinds of at least one are not known
};
[[nodiscard]] FoundModules findModules(const std::vector<ModuleMention>& mentions, ModuleCatalog& catalog, Registry& registry,
                                       Diagnostics& diagnostics);

/// Of the kinds that nobody knows, those that a module of the program would bring get its name and the line that loads it.
void offerModules(const Loaded& loaded, ModuleCatalog& catalog, std::vector<Diagnostic>& diagnostics);

} // namespace trundle
