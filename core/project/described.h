#pragma once
#include <vector>

#include "project/project.h"

namespace trundle {

/// The robots and arenas that the opened file describes where nothing is placed, neither there nor in what it imports: there is
/// something to look at and to edit, and nothing to run. In the order of the text; none where something is placed.
[[nodiscard]] std::vector<const Part*> describedAlone(const Loaded& loaded);

} // namespace trundle
