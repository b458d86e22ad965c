#pragma once
// Several pieces of scenery, or several movable objects, made one piece that can be placed again: a config in a file of its own.

#include <string>
#include <vector>

#include "project/plans.h"

namespace trundle {

struct GroupPlan {
    EditPlan plan;    ///< of the texts that there are: one instance in the place of those
    std::string file; ///< absolute, of the new one
    std::string text; ///< of that
};

/// A name for such a config that is free: "Piece", "Piece2" ... A file of the program's configs is not hidden by one of the same path.
[[nodiscard]] std::string freeGroupName(const Loaded& loaded, const std::string& shippedConfigs);
/// Statics become one StaticConfig, Robots that nothing drives one RobotConfig with their bodies; `name` is that of the config, and the
/// file is objects/<name>.sim in the project's folder. Every shape stays where it is. Params and overrides are written as the values that
/// they have. Materials and surfaces of the opened file that it uses go into the new one. Fails where something else refers to one of the
/// objects, where one stands in another file, and where they are of both sorts.
[[nodiscard]] Result<GroupPlan> planGroup(const Loaded& loaded, const std::vector<std::string>& paths, const std::string& name,
                                          const std::string& shippedConfigs = {});

} // namespace trundle
