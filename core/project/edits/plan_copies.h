#pragma once
#include <string>
#include <vector>

#include <trundle/geometry.h>

#include "project/edits/plans.h"

namespace trundle {

/// Copies objects once for each of `offsets` (m), as planDuplicate(): the copies are written directly behind their originals, without
/// the comments around them. `selects` are the copies.
[[nodiscard]] Result<EditPlan> planCopies(const LoadedProject& loaded, const std::vector<std::string>& paths,
                                          const std::vector<Vec3>& offsets);

} // namespace trundle
