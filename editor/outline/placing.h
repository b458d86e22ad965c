#pragma once
// Where blocks may stand, and where something new goes when somebody has this or that selected.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "project/object_place.h"
#include "project/project.h"

namespace trundle {

/// Whether a block of `kind` may stand in one of kind `parent` ("" is the top level).
[[nodiscard]] bool mayStandIn(const Kind& kind, std::string_view parent);
/// Words for messages: "a RobotConfig", "the top level", "a Robot, a Grid or a Scatter".
[[nodiscard]] std::string placesOf(const Kind& kind);

/// The path of the block that is edited when somebody edits `path`: "robot0.chassis" is "RobotConfig.SimpleRobot.chassis", and
/// a member of a Grid is the Grid. The path itself where it has a block of its own, or where nothing is known of it.
[[nodiscard]] std::string definedAt(const Loaded& loaded, const std::string& path);
/// Kind of the block at a path; nullptr for "" and for what is not there.
[[nodiscard]] const Kind* kindAt(const Loaded& loaded, const std::string& path);
/// "a.b" for "a.b.c"; "" for what stands at the top level ("robot0", "Material.red").
[[nodiscard]] std::string parentOf(const Loaded& loaded, const std::string& path);

/// Blocks that something new may go into when `selected` is selected, nearest first: the block itself, those around it, its
/// instance, the config of an instance, and last "", the top level.
[[nodiscard]] std::vector<std::string> placesAround(const Loaded& loaded, const std::string& selected);
/// The first of them in which blocks of all these kinds may stand. Nothing where there is none.
[[nodiscard]] std::optional<std::string> placeFor(const Loaded& loaded, const std::string& selected,
                                                  std::span<const Kind* const> kinds);
/// A controller block of an instance; nullptr where it has none.
[[nodiscard]] const Part* controllerOf(const Part& instance);

} // namespace trundle
