#pragma once
// Maps dotted paths to blocks and back. Paths begin in the world ("robot0.chassis.hull", "arena.north", "swarm", "poseLog") or
// with a kind ("Material.red", "RobotConfig.SimpleRobot.leftAxle"); "" is the experiment.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "project/loading/project.h"

namespace trundle {

struct ObjectLocation {
    const Part* part = nullptr; ///< its block; for an object reached through an instance, the block in the config
    /// The Robot, Static, Grid or Scatter that it is or is reached through; of a path into a config, the first Part on it.
    const Part* instance = nullptr;
    std::string within;  ///< path below the instance: "chassis.hull"; empty: the instance itself, or no instance
    bool member = false; ///< a member of a Grid or Scatter ("swarm_3"), which has no text of its own
    /// The enclosing blocks of `part`, outermost first; empty: it is at the top level. A Part is followed by its PartConfig.
    std::vector<const Part*> above;
    std::vector<const Part*> around; ///< the Repeats at the top level that it, or its instance, is in, outermost first
    /// The Repeats, Grids and Scatters of which the path names a member ("roller_3"), and its number.
    std::vector<std::pair<const Part*, std::size_t>> members;
    [[nodiscard]] std::optional<std::size_t> memberOf(const Part& part) const;
};

/// Whether a block is a Robot, Static, Grid, Scatter or Part.
[[nodiscard]] inline bool isPlaced(const Part& part) { return part.is(Role::Instance) || part.is(Role::Layout); }

/// The top-level block that the path of a location begins with; nullptr for the experiment.
[[nodiscard]] inline const Part* topOf(const ObjectLocation& place) {
    if (place.instance && !place.instance->isPartUse()) return place.instance;
    return place.above.empty() ? place.part : place.above.front();
}

/// Nothing if the path does not lead to an object ("" gives a location without a part).
[[nodiscard]] std::optional<ObjectLocation> placeOf(const LoadedProject& loaded, std::string_view path);
/// The path of the innermost object whose block contains an offset of a file; "" outside all blocks. Parts of a config have paths
/// like "RobotConfig.SimpleRobot...", never through an instance.
[[nodiscard]] std::string objectAt(const LoadedProject& loaded, FileId file, std::uint32_t offset);
/// The source range of an object's block. The whole opened file for "".
[[nodiscard]] SourceRange blockOf(const LoadedProject& loaded, std::string_view path);
/// The path of a part as declared, from the chain of blocks from the top level down to it; "" if it cannot be reached by name.
[[nodiscard]] std::string pathOf(const LoadedProject& loaded, const std::vector<const Part*>& chain);
/// The config that an instance names, also through a Param; nullptr if there is none.
[[nodiscard]] const Part* configOf(const LoadedProject& loaded, const Part& instance);
/// "RobotConfig.Rover".
[[nodiscard]] std::string pathOfConfig(const Part& config);
/// The controller blocks of an instance.
[[nodiscard]] std::vector<const Part*> controllersOf(const Part& instance);

} // namespace trundle
