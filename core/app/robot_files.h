#pragma once
// A new robot with its experiment and its controller, as files.

#include <string>
#include <vector>

#include "base/result.h"
#include "project/wizard/robot_design.h"

namespace trundle {

/// A robot whose files are written.
struct NewRobot {
    std::string folder;             ///< as given, with the robot's own folder
    std::vector<std::string> files; ///< in that folder: the robot, the experiment, the controller
    std::string experiment;
    MotorChoice choice;
};

/// Why a robot cannot have this name; empty if it can.
[[nodiscard]] std::string robotNameFault(const std::string& name);

/// Writes a robot, an experiment in which it drives a square and the controller that does so into a new folder below `parent`: Rover becomes
/// rover/rover.sim, rover/rover_square.sim and rover/rover_square.py. Fails, and writes nothing, if no motor fits, if the name cannot be
/// a config's, if that folder exists, or if it cannot be written.
[[nodiscard]] Result<NewRobot> makeRobot(const RobotDesign& design, const std::string& parent);

} // namespace trundle
