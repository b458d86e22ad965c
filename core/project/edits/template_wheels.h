#pragma once
// The wheels of a new drive. Private to core/project.

#include <optional>
#include <string>

#include <trundle/geometry.h>

#include "project/edits/template_names.h"

namespace trundle {

struct Wheel {
    Vec3 centre = Vec3::Zero(), axis = Vec3::UnitY(); ///< m, in the config's frame
    double radius = 0;                                ///< m
};

/// What a drive needs to know of its wheels, as drawn: m.
struct WheelPair {
    double radius = 0;     ///< of the left one
    double separation = 0; ///< of their middles, along the axle
};

/// The largest round geom of the body that a RotaryMotor turns. Nothing if the body has no round geom.
[[nodiscard]] std::optional<Wheel> wheelOf(const TemplateNames& names, const std::string& motor);
/// The wheels that two RotaryMotors turn. Nothing if one turns no round geom, or both the same.
[[nodiscard]] std::optional<WheelPair> wheelsOf(const TemplateNames& names, const std::string& leftMotor,
                                                const std::string& rightMotor);

/// How badly a block fits what the name of a property says of its side, as LeftMotor or FrontRightMotor: 0 as well as it can. What has no
/// side in its name has that of the wheel that it turns.
[[nodiscard]] int sideMisfit(const TemplateNames* names, const std::string& property, const std::string& block);

} // namespace trundle
