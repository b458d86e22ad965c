#pragma once
#include <string>
#include <vector>

#include <trundle/geometry.h>

#include "project/loading/project.h"

namespace trundle {

/// The offset along +y (left), in steps of 0.1 m, at which copies do not overlap the originals.
[[nodiscard]] Vec3 duplicateOffset(const LoadedProject& loaded, const std::vector<std::string>& paths);

} // namespace trundle
