#pragma once
#include <vector>

#include "project/loading/project.h"

namespace trundle {

/// The robots and arenas defined in the opened file, if nothing is placed in it or its imports: they can be viewed and edited,
/// but not run. In text order; empty if something is placed.
[[nodiscard]] std::vector<const Part*> configsWithoutInstances(const LoadedProject& loaded);

} // namespace trundle
