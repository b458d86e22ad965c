#pragma once
#include <QString>

namespace trundle {

class RunSession;
struct ControlledRobot;

/// What a robot's controller does now, in words.
struct ControllerState {
    QString text;
    bool active = false, failed = false;
};
[[nodiscard]] ControllerState controllerState(const RunSession& session, const ControlledRobot& robot);

} // namespace trundle
