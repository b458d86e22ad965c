#pragma once
// Which blocks can contain which, and where a new block is inserted for a given selection.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "project/loading/project.h"
#include "project/objects/object_location.h"
#include "schema/allowed_parents.h"

namespace trundle {

/// Text for messages: "a RobotConfig", "the top level", "a Robot, a Grid or a Scatter".
[[nodiscard]] std::string placesOf(const Kind& kind);

/// The path of the block that is edited for `path`: "robot0.chassis" is defined at "RobotConfig.SimpleRobot.chassis", and a
/// member of a Grid by the Grid. `path` itself if it has its own block or is unknown.
[[nodiscard]] std::string definedAt(const LoadedProject& loaded, const std::string& path);
/// Kind of the block at a path; nullptr for "" and for an unknown path.
[[nodiscard]] const Kind* kindAt(const LoadedProject& loaded, const std::string& path);
/// "a.b" for "a.b.c"; "" for a path at the top level ("robot0", "Material.red").
[[nodiscard]] std::string parentOf(const LoadedProject& loaded, const std::string& path);

/// Blocks in which a new block can be inserted while `selected` is selected, nearest first: the block itself, its enclosing
/// blocks, its instance, the config of an instance, and finally "", the top level.
[[nodiscard]] std::vector<std::string> placesAround(const LoadedProject& loaded, const std::string& selected);
/// The first of them in which blocks of all these kinds are allowed. Nothing if there is none.
[[nodiscard]] std::optional<std::string> placeFor(const LoadedProject& loaded, const std::string& selected,
                                                  std::span<const Kind* const> kinds);

} // namespace trundle
