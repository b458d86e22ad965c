#pragma once
// Where a new geom or body starts. Private to core/project.

#include <optional>
#include <string>

#include "model/body_spec.h"
#include "project/loading/project.h"
#include "project/objects/object_location.h"

namespace trundle {

/// A geom as its values have it, so that a config without instances has shapes too. Nothing for planes, and for shapes from files
/// without an instance.
[[nodiscard]] std::optional<GeomSpec> shapeAt(const LoadedProject& loaded, const ObjectLocation& place);

/// A geom with the values that templates of its kind have: 0.1 m wide. Nothing for planes and for shapes from files.
[[nodiscard]] std::optional<GeomSpec> templateShape(const Kind& geom);

/// Pos (m, in its parent's frame) of a geom of that shape that is written into `target`, a Body or StaticConfig, or of a body with
/// that geom at its origin that is written into a RobotConfig. In a Body and a RobotConfig it is on top of all shapes there, in a
/// StaticConfig and where there are no shapes above z = 0 of the config. `path`: of the target or what is in it, perhaps through an
/// instance.
[[nodiscard]] Vec3 templatePosition(const LoadedProject& loaded, const std::string& path, const Part& target,
                                    const GeomSpec& shape);

} // namespace trundle
