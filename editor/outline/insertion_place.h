#pragma once
#include <optional>
#include <string>

#include "project/loading/project.h"

namespace trundle {

/// Where a new block of a kind may be written while `selected` is selected: one of placesAround(). Unlike placeFor() it knows that a
/// Repeat holds what is allowed around it, and a PartConfig of a robot no geoms beside its bodies.
[[nodiscard]] std::optional<std::string> insertionPlaceFor(const LoadedProject& loaded, const std::string& selected,
                                                           const Kind& kind);

/// The text of a Part for `place` that uses a PartConfig. A Param without a default, which joins it to what is around it, gets the
/// first body there. Empty if a Part of it cannot be there.
[[nodiscard]] std::string partTextFor(const LoadedProject& loaded, const std::string& place, const Part& partConfig);

} // namespace trundle
