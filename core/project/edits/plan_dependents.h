#pragma once
#include <string>
#include <vector>

#include "project/loading/project.h"

namespace trundle {

/// Objects that could be removed together with `paths` where planRemove() would refuse: logs, joints, devices, controllers and
/// instances that refer to them, and the dependents of those. Empty if there are none, or if something that should stay refers to
/// them, such as a shape that uses a material.
[[nodiscard]] std::vector<std::string> dependentsOf(const LoadedProject& loaded, const std::vector<std::string>& paths);

} // namespace trundle
