#pragma once
// The texts of a new robot: its description, an experiment with it, and a controller that drives a square.

#include <string>

#include "project/wizard/robot_design.h"

namespace trundle {

/// A RobotConfig `design.name` with the motor, in the standard style.
[[nodiscard]] std::string robotText(const RobotDesign& design, const MotorChoice& choice);

/// The robot on an open floor; `file` is the name that all three files begin with: "rover" of rover.sim, rover_square.sim, rover_square.py.
[[nodiscard]] std::string squareExperimentText(const RobotDesign& design, const std::string& file);

/// In Python: the controller `design.name` + "Square".
[[nodiscard]] std::string squareControllerText(const RobotDesign& design, const std::string& file);

/// What its controller does at first.
struct SquareDrive {
    double side = 1;     ///< m; of a base that steers, from edge to edge with its round corners
    double speed = 0.3;  ///< m/s
    double turnRate = 1; ///< rad/s; of a base that turns on the spot
    double radius = 0;   ///< m, of the corners; of a base that steers
};
[[nodiscard]] SquareDrive squareDrive(const RobotDesign& design);

} // namespace trundle
