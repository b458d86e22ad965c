#include "editor/running/panels/robot_states.h"

#include <algorithm>

#include <QCoreApplication>

#include "editor/running/session.h"
#include "editor/widgets/strings.h"
#include "model/robot_path.h"
#include "project/edits/controllers.h"

namespace trundle {
namespace {

QString trState(const char* text) { return QCoreApplication::translate("ControllersPanel", text); }

/// The stopped controllers of a robot, or of the members of a Grid or Scatter.
bool isController(const std::string& name, const RobotSpec& built, const ControlledRobot& robot) {
    const ControllerSpec* controller = controllerIn(built, robot);
    return controller && controller->name == name;
}

std::vector<const StoppedController*> stoppedOf(const RunSession& session, const ControlledRobot& robot) {
    std::vector<const StoppedController*> found;
    const RunResults& results = session.results();
    if (!results.snapshot) return found;
    for (const StoppedController& stopped : results.snapshot->stopped)
        if (const RobotSpec& built = results.experiment->robots[stopped.robot];
            isRobotOf(session, built.name, robot) && isController(stopped.controller, built, robot))
            found.push_back(&stopped);
    return found;
}

ControllerState stoppedState(const std::vector<const StoppedController*>& stopped, const ControlledRobot& robot) {
    const StoppedController& first = *stopped.front();
    const bool byCommand = std::ranges::all_of(stopped, &StoppedController::byCommand);
    if (byCommand)
        return {robot.members == 1 ? trState("stopped") : trState("%1 of %2 stopped").arg(QString::number(stopped.size()),
                                                                                            QString::number(robot.members)),
                false, false, trState("Stopped at t = %1 s; Restart starts it again").arg(QString::number(first.time))};
    QString detail = trState("At t = %1 s %2").arg(QString::number(first.time), toQString(first.fault.reason));
    for (const std::string& line : first.fault.backtrace) detail += QStringLiteral("\n  ") + toQString(line);
    const QString text = robot.members == 1 ? trState("stopped by a fault, see Problems")
                                            : trState("%1 of %2 stopped by a fault, see Problems")
                                                  .arg(QString::number(stopped.size()), QString::number(robot.members));
    return {text, false, true, detail};
}

} // namespace

bool isRobotOf(const RunSession& session, const std::string& built, const ControlledRobot& robot) {
    const auto& project = session.results().built;
    return built == robot.path || (project && isNamedBy(built, robot.path, IsOwnName{*project->outline}));
}

const RobotSpec* firstRobotOf(const ExperimentSpec& experiment, const Outline& outline, const ControlledRobot& robot) {
    const auto isMeant = [&](const RobotSpec& spec) { return isNamedBy(spec.name, robot.path, IsOwnName{outline}); };
    auto first = std::ranges::find(experiment.robots, robot.path, &RobotSpec::name); // much faster, and most often there
    if (first == experiment.robots.end()) first = std::ranges::find_if(experiment.robots, isMeant);
    return first == experiment.robots.end() ? nullptr : &*first;
}

const ControllerSpec* controllerIn(const RobotSpec& built, const ControlledRobot& robot) {
    const auto named = std::ranges::find(built.controllers, robot.controller, &ControllerSpec::name);
    if (named != built.controllers.end()) return &*named;
    return built.controllers.size() == 1 && robot.controllers <= 1 ? &built.controllers.front() : nullptr;
}

ControllerState controllerState(const RunSession& session, const ControlledRobot& robot) {
    const auto experiment = session.results().experiment;
    if (!experiment) return {robot.kind.empty() ? trState("no controller") : trState("waits for a run"), false, false};
    // A Grid, Scatter or what is in a Repeat is represented by its first member.
    const RobotSpec* built = firstRobotOf(*experiment, *session.results().built->outline, robot);
    if (!built) return {trState("not in this run"), false, false};
    if (const std::size_t ended = session.robots().ended().countOf(robot.path); ended > 0)
        return {
            robot.members == 1
                ? trState("ended by a fault, see Problems")
                : trState("%1 of %2 ended by a fault, see Problems").arg(QString::number(ended), QString::number(robot.members)),
            false, true, session.robots().ended().explanation(robot.path)};
    const ControllerSpec* controller = controllerIn(*built, robot);
    if (!controller) return {robot.kind.empty() ? trState("no controller") : trState("not in this run"), false, false};
    if (const auto stopped = stoppedOf(session, robot); !stopped.empty()) return stoppedState(stopped, robot);
    const std::optional<LiveEnd>& end = session.results().end;
    if (end && end->failure && end->failure->range.known() && end->failure->range == controller->nameRange)
        return {QString::fromStdString(end->failure->message), false, true};
    if (controller->kind != robot.kind)
        return {trState("%1 until Reset").arg(QString::fromStdString(controller->kind)), true, false};
    switch (session.state()) {
    case RunState::Building: return {trState("is created"), true, false};
    case RunState::Running:
        return {isRobotOf(session, session.robots().driven(), robot) && !session.robots().driven().empty()
                    ? trState("paused: driven from the keyboard")
                    : trState("runs"),
                true, false};
    case RunState::Paused: return {trState("paused"), true, false};
    default: return {trState("ended"), false, false};
    }
}

} // namespace trundle
