#pragma once
// The wheels of a new drive. Private to core/project.

#include <optional>
#include <string>

#include "project/loading/project.h"

namespace trundle {

/// What a drive needs to know of its wheels, as drawn: m.
struct WheelPair {
    double radius = 0;     ///< of the left one
    double separation = 0; ///< of their middles, along the axle
};

/// The wheels that two RotaryMotors of a config turn, by their names. Nothing if one turns no round geom, or both the same.
[[nodiscard]] std::optional<WheelPair> wheelsOf(const LoadedProject& loaded, const Part& config, const std::string& leftMotor,
                                                const std::string& rightMotor);

} // namespace trundle
