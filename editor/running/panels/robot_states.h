#pragma once
#include <string>

#include <QString>

namespace trundle {

class RunSession;
struct ControlledRobot;

/// The state of a robot's controller, for display.
struct ControllerState {
    QString text;
    bool active = false, failed = false;
    QString detail = {}; ///< for a tool tip; or empty
};
/// Whether a robot of the run, by its name there, is this one or a member of it.
[[nodiscard]] bool isRobotOf(const RunSession& session, const std::string& built, const ControlledRobot& robot);
[[nodiscard]] ControllerState controllerState(const RunSession& session, const ControlledRobot& robot);

} // namespace trundle
