#pragma once
// Groups several Statics, or several Robots that nothing drives, into one config in a file of its own.

#include <string>
#include <vector>

#include "project/edits/plans.h"

namespace trundle {

struct GroupPlan {
    EditPlan plan;    ///< edits of the existing files: one instance replaces the objects
    std::string file; ///< absolute path of the new file
    std::string text; ///< content of the new file
};

/// A free name for a grouped config: "Piece", "Piece2" ... Its file must not hide a shipped one with the same relative path.
[[nodiscard]] std::string freeGroupName(const LoadedProject& loaded, const std::string& shippedConfigs);
/// Statics become one StaticConfig, Robots that nothing drives one RobotConfig with their bodies, those of a Grid or Scatter too; `name` is the name of the
/// config, and its file is objects/<name>.sim in the project's folder. Every shape keeps its pose in the world. Params and
/// overrides are replaced by their values. Materials and surfaces of the opened file that are used are moved to the new file.
/// Fails if something else refers to one of the objects, if one is in another file, or if both types are mixed.
[[nodiscard]] Result<GroupPlan> planGroup(const LoadedProject& loaded, const std::vector<std::string>& paths,
                                          const std::string& name, const std::string& shippedConfigs = {});

} // namespace trundle
