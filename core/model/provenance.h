#pragma once
// Where a value comes from, found in the outline when somebody asks: a thousand robots cost nothing.

#include <optional>
#include <string_view>

#include "model/component_spec.h"
#include "model/outline.h"

namespace trundle {

struct Provenance {
    Origin origin = Origin::Default;
    SourceRange value; ///< its text; unknown for a default
    SourceRange block; ///< name of the block that holds it, or would
    const Property* property = nullptr;
};

/// Of a dotted path: "robot0.chassis.hull.Mass", "robot0.leftMotor.Resistance", "robot0.brain.Speed", "Surface.rubber.Friction",
/// "RobotConfig.SimpleRobot.leftAxle.Axis", "Tick". Nothing when there is no such property. Members of a Grid or Scatter
/// ("swarm_3.leftMotor.Resistance") answer for all of them.
[[nodiscard]] std::optional<Provenance> provenanceOf(const Outline& outline, std::string_view path);

} // namespace trundle
