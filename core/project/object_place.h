#pragma once
// Which block of which text a dotted path means, and the other way round. Paths begin in the world ("robot0.chassis.hull",
// "arena.north", "swarm", "poseLog") or with a kind ("Material.red", "RobotConfig.SimpleRobot.leftAxle"); "" is the experiment.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "project/project.h"

namespace trundle {

struct ObjectPlace {
    const Part* part = nullptr;     ///< its block; of something reached through an instance, the block in the config
    const Part* instance = nullptr; ///< the Robot, Static, Grid or Scatter it is reached through, or that it is
    std::string within;             ///< path below the instance: "chassis.hull"; empty: it is the instance, or there is none
    bool member = false;            ///< "swarm_3": one of a Grid or Scatter, which has no text of its own
    std::vector<const Part*> above; ///< the blocks round `part`, outermost first; empty: it stands at the top level
};

/// A Robot, Static, Grid or Scatter.
[[nodiscard]] inline bool isPlaced(const Part& part) { return part.is(Role::Instance) || part.is(Role::Layout); }

/// Nothing where the path names no object ("" has a place without a part).
[[nodiscard]] std::optional<ObjectPlace> placeOf(const Loaded& loaded, std::string_view path);
/// The path of the innermost object whose block holds an offset of a file; "" outside all blocks. Parts of a config give
/// "RobotConfig.SimpleRobot...", never an instance.
[[nodiscard]] std::string objectAt(const Loaded& loaded, FileId file, std::uint32_t offset);
/// Where the object stands in the text: its whole block. The whole opened file for "".
[[nodiscard]] SourceRange blockOf(const Loaded& loaded, std::string_view path);
/// The path of a part as declared, by the blocks from the top level down to it; "" where names do not lead there.
[[nodiscard]] std::string pathOf(const Loaded& loaded, const std::vector<const Part*>& chain);
/// The config that an instance names, also where a Param names it; nullptr where there is none.
[[nodiscard]] const Part* configOf(const Loaded& loaded, const Part& instance);

} // namespace trundle
