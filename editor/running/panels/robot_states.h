#pragma once
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
[[nodiscard]] ControllerState controllerState(const RunSession& session, const ControlledRobot& robot);

} // namespace trundle
