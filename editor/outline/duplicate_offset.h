#pragma once
#include <string>
#include <vector>

#include <trundle/geometry.h>

#include "project/project.h"

namespace trundle {

/// How far to the left (+y) copies go so that they stand clear of what they are copies of, in steps of 0.1 m.
[[nodiscard]] Vec3 duplicateOffset(const Loaded& loaded, const std::vector<std::string>& paths);

} // namespace trundle
