#include "run/controller_set.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <trundle/abi.h>

#include "run/command_signals.h"
#include "schema/value_words.h"

namespace trundle {
namespace {

constexpr std::size_t kMaxControllerErrors = 20; // equal errors of several robots count once

CallTarget targetOf(const RobotSpec& robot, std::size_t index) {
    const std::string& kind = robot.controller->kind;
    return {"the controller " + kind + " of " + robot.name, robot.name, kind, {}, static_cast<std::uint32_t>(index)};
}

Diagnostic faultDiagnostic(Severity severity, double time, const std::string& text, SourceRange range) {
    return {severity, Code::ControllerFailed, "at t = " + numberText(time) + " s " + text, range, {}, {}, {}};
}

std::string slowText(const RobotSpec& robot, double seconds, double budget) {
    return "an update of the controller " + robot.controller->name + " took " + numberText(std::round(1e4 * seconds) / 10) +
           " ms; its Budget is " + numberText(1e3 * budget) + " ms";
}

} // namespace

void ControllerSet::start(const BackendFactory& backends, Diagnostics& diagnostics) {
    std::set<std::string> said;
    const auto report = [&](const Error& error, const ComponentSpec& spec) {
        if (said.insert(spec.kind + "\n" + error.message).second) diagnostics.error(error.code, spec.nameRange, error.message);
    };
    const std::vector<RobotSpec>& robots = experiment().robots;
    for (std::size_t i = 0; i < robots.size() && said.size() < kMaxControllerErrors; ++i) {
        if (!robots[i].controller) continue;
        const ComponentSpec& spec = *robots[i].controller;
        Result<std::unique_ptr<ControllerBackend>> backend = backends(robots[i], experiment().settings);
        if (!backend) {
            report(backend.error(), spec);
            continue;
        }
        m_controllers.push_back({i, std::move(backend).value(), Schedule(spec.number("UpdatePeriod"), experiment().settings.tick),
                                 m_context.calls.add(targetOf(robots[i], i)), spec.number("Budget")});
        const MonitoredCall call(m_context.calls, m_controllers.back().target, "setup");
        const Status started = m_controllers.back().backend->start(m_context.world.layout(), m_context.world.block(),
                                                                   m_context.outputsFor(robots[i]));
        if (!started) report(started.error(), spec);
    }
}

RunningController* ControllerSet::controllerOf(const std::string& robot) {
    const auto it = std::ranges::find_if(m_controllers,
                                         [&](const RunningController& c) { return experiment().robots[c.robot].name == robot; });
    return it == m_controllers.end() ? nullptr : &*it;
}

/// Ignored for a robot without a controller.
Status ControllerSet::apply(const HoldCommand& hold) {
    if (RunningController* controller = controllerOf(hold.robot)) controller->held = hold.held;
    return {};
}

/// Nothing if the object is not a controller.
std::optional<Status> ControllerSet::set(const PropertyCommand& command) {
    const std::size_t slash = command.object.find('/');
    RunningController* controller = controllerOf(command.object.substr(0, slash));
    const bool meant = controller && slash != std::string::npos &&
                       experiment().robots[controller->robot].controller->name == command.object.substr(slash + 1);
    if (!meant) return std::nullopt;
    const MonitoredCall call(m_context.calls, controller->target, "set");
    return controller->backend->set(command.property, command.value);
}

Status ControllerSet::apply(const RestartCommand& restart) {
    RunningController* chosen = controllerOf(restart.robot);
    if (!chosen) return Error{Code::NoSuchPath, restart.robot + " has no controller"};
    const ControllerFault* fault = chosen->backend->fault();
    const std::string process = fault ? fault->process : std::string();
    for (RunningController& controller : m_controllers) {
        const ControllerFault* other = controller.backend->fault();
        if (&controller != chosen && (process.empty() || !other || other->process != process)) continue;
        const RobotSpec& robot = experiment().robots[controller.robot];
        if (startAgain(controller))
            m_context.say(robot.name, TRUNDLE_INFO, "the controller " + robot.controller->name + " was started again");
    }
    stopFaulty(); // a crash in setup ends the process of other robots too
    return {};
}

Status ControllerSet::apply(const StopCommand& stop) {
    const RunningController* controller = controllerOf(stop.robot);
    if (!controller || isStopped(*controller)) return {};
    const RobotSpec& robot = experiment().robots[controller->robot];
    m_stopped.push_back({controller->robot, m_context.world.time(), {}, true});
    m_context.say(robot.name, TRUNDLE_INFO, "the controller " + robot.controller->name + " was stopped");
    setCommandsToZero(m_context.world, robot);
    return {};
}

/// From its setup, in a new process if the old one has ended.
bool ControllerSet::startAgain(RunningController& controller) {
    std::erase_if(m_stopped, [&](const StoppedController& stopped) { return stopped.robot == controller.robot; });
    controller.called = controller.slow = false;
    ++controller.cost.restarts;
    const RobotSpec& robot = experiment().robots[controller.robot];
    const MonitoredCall call(m_context.calls, controller.target, "setup");
    const Status started =
        controller.backend->start(m_context.world.layout(), m_context.world.block(), m_context.outputsFor(robot));
    if (started || controller.backend->fault()) return started.ok(); // the fault is reported by stopFaulty()
    m_stopped.push_back({controller.robot, m_context.world.time(), {started.error().message, {}, {}, true}});
    m_context.say(robot.name, TRUNDLE_ERROR, started.error().message);
    setCommandsToZero(m_context.world, robot);
    return false;
}

/// What its code hands over to the new one. All are asked before the first is replaced: they may share a process.
std::string ControllerSet::stateOf(RunningController& controller) {
    if (isStopped(controller) || controller.backend->fault()) return {};
    const MonitoredCall call(m_context.calls, controller.target, "saveState");
    Result<std::string> state = controller.backend->saveState();
    if (state) return std::move(state).value();
    m_context.say(experiment().robots[controller.robot].name, TRUNDLE_WARNING,
                  "no state is handed over: " + state.error().message);
    return {};
}

/// Without the state if the new code does not take it.
bool ControllerSet::startFrom(RunningController& controller, const std::string& state) {
    if (!startAgain(controller)) return false;
    if (state.empty()) return true;
    Status loaded;
    {
        const MonitoredCall call(m_context.calls, controller.target, "loadState");
        loaded = controller.backend->loadState(state);
    }
    if (loaded) return true;
    m_context.say(experiment().robots[controller.robot].name, TRUNDLE_WARNING,
                  "the state of the old code is not used: " + loaded.error().message);
    return startAgain(controller);
}

Status ControllerSet::apply(const ReloadCommand& reload) {
    ++m_requests;
    std::set<std::string> said;
    std::vector<std::string> states;
    const auto isMeant = [&](const RunningController& c) {
        return reload.module.empty() || c.backend->module() == reload.module;
    };
    for (RunningController& controller : m_controllers)
        states.push_back(isMeant(controller) ? stateOf(controller) : std::string());
    for (RunningController& controller : m_controllers) {
        const std::string library = controller.backend->module();
        const std::string& state = states[static_cast<std::size_t>(&controller - m_controllers.data())];
        if (!isMeant(controller)) continue;
        const RobotSpec& robot = experiment().robots[controller.robot];
        const MonitoredCall call(m_context.calls, controller.target, "load");
        if (const Status renewed = controller.backend->renew(m_requests); !renewed) {
            if (said.insert(robot.controller->kind + renewed.error().message).second)
                m_context.say(robot.name, TRUNDLE_ERROR,
                              "the controller " + robot.controller->kind +
                                  " continues with its old code: " + renewed.error().message);
        } else if (startFrom(controller, state)) {
            m_context.say(robot.name, TRUNDLE_INFO,
                          "the controller " + robot.controller->name + " has the new code of " + library);
        }
    }
    stopFaulty();
    return {};
}

bool ControllerSet::isStopped(const RunningController& controller) const {
    return std::ranges::find(m_stopped, controller.robot, &StoppedController::robot) != m_stopped.end();
}

/// Announces all updates of this tick before the first, so that a host process gets them together.
void ControllerSet::prepareUpdates(std::uint64_t tick, double time) {
    for (RunningController& controller : m_controllers) {
        controller.due = controller.schedule.due(tick) && !controller.held && !hasEnded(m_context.world, controller.robot) &&
                         !isStopped(controller);
        if (controller.due) controller.prepare(tick, time);
    }
}

Status ControllerSet::update(RunningController& controller, std::uint64_t tick, double time) {
    const Status done = controller.update(tick, time, m_context.calls, m_context.measures);
    // Once for each controller. The time depends on the machine, so it goes to the console and affects nothing.
    const RobotSpec& robot = experiment().robots[controller.robot];
    if (const auto slow = controller.takeSlow())
        m_context.say(robot.name, TRUNDLE_WARNING, slowText(robot, *slow, controller.budget));
    return done;
}

/// After a fault of one controller: its robot gets commands of 0. Those whose controllers shared its process continue in a new one.
/// That may have a fault too, but each stops one controller more, so this ends.
void ControllerSet::stopFaulty() {
    for (bool again = true; std::exchange(again, false);)
        for (RunningController& controller : m_controllers) {
            const ControllerFault* fault = controller.backend->fault();
            if (!fault || isStopped(controller)) continue;
            again = true;
            if (!fault->isOwn && !m_ending) {
                goOnInNewProcess(controller);
                continue;
            }
            reportFault(controller);
            setCommandsToZero(m_context.world, experiment().robots[controller.robot]);
        }
}

void ControllerSet::goOnInNewProcess(RunningController& controller) {
    const std::string reason = controller.backend->fault()->reason;
    if (!startAgain(controller)) return;
    m_context.warnings.push_back(faultDiagnostic(Severity::Warning, m_context.world.time(),
                                                 reason + "; it was started again in a new process, without what it had stored",
                                                 experiment().robots[controller.robot].controller->nameRange));
}

void ControllerSet::reportFault(const RunningController& controller) {
    const ControllerFault& fault = *controller.backend->fault();
    const double time = tickTime(m_context.world.ticks(), experiment().settings.tick);
    m_stopped.push_back({controller.robot, time, fault});
    const SourceRange range = experiment().robots[controller.robot].controller->nameRange;
    m_context.warnings.push_back(
        faultDiagnostic(Severity::Error, time, fault.reason + (m_ending ? "" : "; the run continues without it"), range));
}

/// A destructor may have a fault too.
void ControllerSet::stop() {
    m_ending = true;
    for (RunningController& controller : m_controllers) {
        const MonitoredCall call(m_context.calls, controller.target, "destructor");
        controller.backend->stop();
        const ControllerFault* fault = controller.backend->fault();
        if (fault && fault->isOwn && !isStopped(controller)) reportFault(controller);
    }
}

std::optional<std::pair<Error, SourceRange>> ControllerSet::think() {
    const std::uint64_t tick = m_context.world.ticks();
    const double time = m_context.world.time();
    prepareUpdates(tick, time);
    for (RunningController& controller : m_controllers)
        while (controller.due && !isStopped(controller)) { // again if it was started in a new process
            const Status done = update(controller, tick, time);
            if (done) break;
            if (!controller.backend->fault())
                return std::pair(done.error(), experiment().robots[controller.robot].controller->nameRange);
            stopFaulty();
        }
    return std::nullopt;
}

std::vector<ControllerCost> ControllerSet::costs() const {
    std::vector<ControllerCost> all;
    for (const RunningController& controller : m_controllers) all.push_back(controller.costNow());
    return all;
}

} // namespace trundle
