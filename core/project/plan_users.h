#pragma once
#include <string>
#include <vector>

#include "project/project.h"

namespace trundle {

/// What could go together with these objects where planRemove() refuses because it refers to them: paths of logs, joints, devices,
/// controllers and of what is made from a config, and whatever refers to those in turn. Empty where nothing refers to them, or
/// where something does that should stay: a shape with a material, say.
[[nodiscard]] std::vector<std::string> usersOf(const Loaded& loaded, const std::vector<std::string>& paths);

} // namespace trundle
