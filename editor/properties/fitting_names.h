#pragma once
#include <string>
#include <vector>

#include "project/loading/project.h"

namespace trundle {

/// The names that are valid for a reference, in the order of the text. `config`: the one that contains the object or that it is
/// an instance of; may be null.
[[nodiscard]] std::vector<std::string> fittingNames(const LoadedProject& loaded, const Property& property, const Part* config);
/// Names of robots, grids and scatters.
[[nodiscard]] std::vector<std::string> robotNames(const LoadedProject& loaded);

} // namespace trundle
