#pragma once
#include <string>
#include <vector>

#include "project/project.h"

namespace trundle {

/// The names that would do for a reference, in the order of the text. `config`: the one in which the object stands or from which
/// it is made; may be missing.
[[nodiscard]] std::vector<std::string> fittingNames(const Loaded& loaded, const Property& property, const Part* config);
/// Robots, grids and scatters.
[[nodiscard]] std::vector<std::string> robotNames(const Loaded& loaded);

} // namespace trundle
