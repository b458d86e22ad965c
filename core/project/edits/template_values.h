#pragma once
// Values of a new block that no other block gives. Private to core/project.

#include <string>

#include "project/loading/project.h"

namespace trundle {

/// A number within the limits, of a typical size for its unit.
[[nodiscard]] double likelyNumber(const Property& p);
/// A file of a suitable type, in quotes: one in the project, else one shipped with the program. `name`: of the new block.
[[nodiscard]] std::string likelyFile(const LoadedProject& loaded, const Property& p, const std::string& name);

} // namespace trundle
