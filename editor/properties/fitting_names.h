#pragma once
#include <optional>
#include <string>
#include <vector>

#include "project/loading/project.h"
#include "project/objects/object_values.h"

namespace trundle {

/// The names that are valid for a reference, in the order of the text. `config`: the one that contains the object or that it is
/// an instance of; may be null.
[[nodiscard]] std::vector<std::string> fittingNames(const LoadedProject& loaded, const Property& property, const Part* config);
/// The same for a Param that an instance gives: names beside it for a Part, in its config for a robot. `property`: see propertyNamedBy().
[[nodiscard]] std::vector<std::string> fittingNames(const LoadedProject& loaded, const Property& property,
                                                    const ObjectValues& instance);
/// Whether the property is the In of a Body, Part, Repeat or Ring.
[[nodiscard]] bool isBodyToCountFrom(const Kind& kind, const Property& property);
/// The bodies that In of an object may name. Nothing: In has no meaning at the top level and for the geoms of a Body.
[[nodiscard]] std::optional<std::vector<std::string>> bodiesForIn(const LoadedProject& loaded, const std::string& path);
/// Names of robots, grids and scatters.
[[nodiscard]] std::vector<std::string> robotNames(const LoadedProject& loaded);

} // namespace trundle
