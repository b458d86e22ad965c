#pragma once
#include <span>
#include <string>

#include "project/objects/part_values.h"
#include "scene/queries/object_index.h"

namespace trundle {

/// The text of a property ("robot0.hull.Size") where an edit through this path would replace it; empty: it gets a new value.
[[nodiscard]] std::string textInPlace(const LoadedProject& loaded, const std::string& property);

/// Whether a pose is worked out from the number of a member of a Repeat in a text that an edit through this path would not
/// change, so that it would put all members in one place. `place`: of the object; a value that is written for one member is
/// that one's.
[[nodiscard]] bool isPlacedByIndex(const LoadedProject& loaded, const std::string& path, const ObjectLocation& place);

/// Whether an object ("robot0.mast") has these properties from the text that a path names ("RobotConfig.Rover.mast"): its
/// instance sets none of them.
[[nodiscard]] bool hasTextsOf(const LoadedProject& loaded, const std::string& path, const std::string& object,
                              std::span<const char* const> keys);
/// The first one of the objects that a path means that has them from there; the first one of all if none has.
[[nodiscard]] ObjectRef objectWithTexts(const LoadedProject& loaded, const std::string& path, const ObjectIndex& objects,
                                        std::span<const ObjectRef> meant, std::span<const char* const> keys);
/// A geom with the sizes that its text has at a place.
[[nodiscard]] GeomSpec sizedByText(const LoadedProject& loaded, const ObjectLocation& place, GeomSpec geom);

} // namespace trundle
