#pragma once
#include <string>
#include <vector>

#include "project/loading/project.h"

namespace trundle {

/// What changes with the removal of objects, see planRemove().
struct Dependents {
    std::vector<std::string> removed;   ///< paths of the blocks that have to be removed too
    std::vector<std::string> shortened; ///< whose lists lose a name, as a title: "Region goal", "NoContact"
};

/// Objects that could be removed together with `paths` where planRemove() would refuse: logs, joints, devices, controllers and
/// instances that refer to them, and the dependents of those; and the lists that name one of them with others. Empty if there are
/// none, or if something that should stay refers to them, such as a shape that uses a material.
[[nodiscard]] Dependents dependentsOf(const LoadedProject& loaded, const std::vector<std::string>& paths);

} // namespace trundle
