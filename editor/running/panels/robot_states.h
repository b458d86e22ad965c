#pragma once
#include <string>

#include <QString>

namespace trundle {

class RunSession;
struct ControlledRobot;
struct ControllerSpec;
struct ExperimentSpec;
class Outline;
struct RobotSpec;

/// The state of a robot's controller, for display.
struct ControllerState {
    QString text;
    bool active = false, failed = false;
    QString detail = {}; ///< for a tool tip; or empty
};
/// Whether a robot of the run, by its name there, is this one or a member of it.
[[nodiscard]] bool isRobotOf(const RunSession& session, const std::string& built, const ControlledRobot& robot);
/// The robot of an experiment that this one is, or its first member; nullptr: none. `outline`: of the experiment's text.
[[nodiscard]] const RobotSpec* firstRobotOf(const ExperimentSpec& experiment, const Outline& outline,
                                            const ControlledRobot& robot);
/// The controller in a run; nullptr if the robot has none of this name there, and not just one.
[[nodiscard]] const ControllerSpec* controllerIn(const RobotSpec& built, const ControlledRobot& robot);
[[nodiscard]] ControllerState controllerState(const RunSession& session, const ControlledRobot& robot);

} // namespace trundle
