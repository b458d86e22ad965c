#pragma once
#include <string>
#include <vector>

#include <trundle/geometry.h>

#include "project/loading/project.h"

namespace trundle {

/// The step along +y (left, m) at which the members of a Repeat of these objects are apart: their width, rounded up. 0.1 m for what has no
/// shape.
[[nodiscard]] Vec3 repeatStep(const LoadedProject& loaded, const std::vector<std::string>& paths);

} // namespace trundle
