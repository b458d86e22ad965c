#pragma once
// The source of a value, looked up in the outline on demand, so that it needs no memory per robot.

#include <optional>
#include <string_view>

#include "model/component_spec.h"
#include "model/outline.h"

namespace trundle {

struct Provenance {
    Origin origin = Origin::Default;
    SourceRange value; ///< source range of the value; unknown for a default
    SourceRange block; ///< name of the block that contains it, or would contain it
    const Property* property = nullptr;
};

/// The provenance of a dotted path: "robot0.chassis.hull.Mass", "robot0.leftMotor.Resistance", "robot0.brain.Speed",
/// "Surface.rubber.Friction", "RobotConfig.SimpleRobot.leftAxle.Axis", "Tick". Nothing if there is no such property. All members
/// of a Grid or Scatter ("swarm_3.leftMotor.Resistance") have the same provenance.
[[nodiscard]] std::optional<Provenance> provenanceOf(const Outline& outline, std::string_view path);

/// The config that a Robot, Static, Grid or Scatter names, directly or through a Param; nullptr if there is none.
[[nodiscard]] const Part* configOf(const Outline& outline, const Part& instance);

} // namespace trundle
