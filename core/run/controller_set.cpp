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

CallTarget targetOf(const RobotSpec& robot, const ControllerSpec& controller, std::size_t index) {
    return {controllerTitle(robot, controller), robot.name, controller.kind, {}, static_cast<std::uint32_t>(index)};
}

std::string atTime(double time) { return "at t = " + numberText(time) + " s "; }

Diagnostic faultDiagnostic(Severity severity, double time, const std::string& text, const RunningController& controller,
                           CodePlace place = {}) {
    const ControllerSpec& spec = controller.spec();
    Diagnostic d{severity, Code::ControllerFailed, atTime(time) + text, spec.nameRange, {}, {}, {}};
    d.robot = controller.robot;
    d.controller = spec.name;
    d.place = std::move(place);
    return d;
}

std::string slowText(const ControllerSpec& controller, double seconds, double budget) {
    const double ms = 1e3 * seconds;
    const double step =
        ms < 1 ? std::pow(10, std::ceil(-std::log10(ms)) + 1) : 10; // a short time with as many digits as it needs
    return "an update of the controller " + controller.name + " took " + numberText(std::round(step * ms) / step) +
           " ms; its Budget is " + numberText(1e3 * budget) + " ms";
}

/// A robot with one more controller, and its index: behind all that it has or had in this run, whose indices stay theirs.
std::pair<std::shared_ptr<RobotSpec>, std::size_t> viewForOneMore(const RobotSpec& robot,
                                                                  const std::vector<RunningController>& controllers) {
    auto view = std::make_shared<RobotSpec>(robot);
    std::size_t index = 0;
    for (const RunningController& each : controllers)
        if (each.view->name == robot.name && each.controller >= index) {
            view->controllers = each.view->controllers;
            index = each.controller + 1;
        }
    view->controllers.resize(index + 1);
    return {std::move(view), index};
}

} // namespace

void ControllerSet::start(const BackendFactory& backends, Diagnostics& diagnostics) {
    std::set<std::string> said;
    const auto report = [&](const Error& error, const ComponentSpec& spec) {
        if (said.insert(spec.kind + "\n" + error.message).second)
            diagnostics.error(error.code, spec.nameRange, error.message).place = error.place;
    };
    m_backends = backends;
    const std::vector<RobotSpec>& robots = experiment().robots;
    for (std::size_t i = 0; i < robots.size(); ++i)
        for (std::size_t k = 0; k < robots[i].controllers.size() && said.size() < kMaxControllerErrors; ++k) {
            // The experiment outlives the run.
            const std::shared_ptr<const RobotSpec> view(std::shared_ptr<void>(), &robots[i]);
            Status started = add(i, view, k, {});
            if (started)
                started = m_controllers.back().start(m_context.world, outputsOf(m_controllers.size() - 1), m_context.calls);
            if (!started) report(started.error(), robots[i].controllers[k]);
        }
}

Status ControllerSet::add(std::size_t robot, std::shared_ptr<const RobotSpec> view, std::size_t controller,
                          const std::string& library, RunningController* old) {
    Result<std::unique_ptr<ControllerBackend>> backend = m_backends({view, controller, experiment().settings, library});
    if (!backend) return backend.error();
    const ControllerSpec& spec = view->controllers[controller];
    if (!library.empty()) m_context.calls.setModule(spec.kind, library);
    const CallTarget* target = m_context.calls.add(targetOf(*view, spec, robot));
    if (old) remove(*old);
    RunningController made{robot, std::move(view), controller, std::move(backend).value(),
                           Schedule(spec.number("UpdatePeriod"), experiment().settings.tick), target, spec.number("Budget")};
    if (old) *old = std::move(made);
    else m_controllers.push_back(std::move(made));
    return {};
}

/// Its place stays, since others refer to theirs by index.
void ControllerSet::remove(RunningController& controller) {
    controller.stop(m_context.calls);
    setItsCommandsToZero(controller);
    forgetStop(controller);
    controller.backend.reset(); // before the robot that its outputs refer to
    m_claims.forget(controller.robot, indexOf(controller));
    controller.removed = true;
}

Status ControllerSet::apply(const SwapCommand& swap) {
    const auto robot = std::ranges::find(experiment().robots, swap.robot, &RobotSpec::name);
    if (robot == experiment().robots.end()) return Error{Code::NoSuchPath, "there is no robot " + swap.robot};
    RunningController* old = swap.controller.empty() ? nullptr : controllerOf(swap.robot, swap.controller);
    if (!old && !swap.controller.empty()) return Error{Code::NoSuchPath, swap.robot + " has no controller " + swap.controller};
    if (!swap.to) {
        if (!old) return Error{Code::NoSuchPath, "no controller of " + swap.robot + " is named"};
        m_context.say(swap.robot, TRUNDLE_INFO, "the controller " + swap.controller + " was removed");
        remove(*old);
        return {};
    }
    if (const RunningController* same = controllerOf(swap.robot, swap.to->name); same && same != old)
        return Error{Code::DuplicateName, swap.robot + " has a controller " + swap.to->name + " already"};
    auto [view, index] =
        old ? std::pair(std::make_shared<RobotSpec>(*old->view), old->controller) : viewForOneMore(*robot, m_controllers);
    view->controllers[index] = *swap.to;
    const std::size_t place = old ? indexOf(*old) : m_controllers.size();
    if (Status made =
            add(static_cast<std::size_t>(robot - experiment().robots.begin()), std::move(view), index, swap.library, old);
        !made)
        return made;
    m_controllers[place].held = !m_holders[swap.robot].empty();
    if (startAgain(m_controllers[place])) {
        m_controllers[place].cost.restarts = 0;
        m_context.say(swap.robot, TRUNDLE_INFO, "the controller " + swap.to->name + " is " + swap.to->kind + " now");
    }
    stopFaulty();
    return {};
}

ControllerOutputs ControllerSet::outputsOf(std::size_t controller) {
    m_claims.forget(m_controllers[controller].robot, controller);
    const RobotSpec& robot = *m_controllers[controller].view;
    ControllerOutputs outputs = m_context.outputsFor(robot, m_controllers[controller].spec());
    outputs.claim = [this, controller](const std::string& command) { return claim(controller, command); };
    return outputs;
}

Status ControllerSet::claim(std::size_t controller, const std::string& command) {
    const RunningController& own = m_controllers[controller];
    const auto signal = m_context.world.layout().find(command);
    if (!signal) return Error{Code::UnknownPort, "there is no command " + command};
    const std::size_t owner = m_claims.claim(own.robot, *signal, controller);
    if (owner == controller) return {};
    return Error{Code::MultipleControllers, own.spec().name + " and " + m_controllers[owner].spec().name + " both command " +
                                                command + ": each controller of a robot needs commands of its own"};
}

/// Those of a robot's only controller are all that the robot has.
void ControllerSet::setItsCommandsToZero(const RunningController& controller) {
    const auto isOther = [&](const RunningController& c) {
        return &c != &controller && !c.removed && c.robot == controller.robot;
    };
    if (std::ranges::none_of(m_controllers, isOther)) return setCommandsToZero(m_context.world, *controller.view);
    m_claims.setToZero(controller.robot, indexOf(controller), m_context.world.block());
}

std::vector<RunningController*> ControllerSet::controllersOf(const std::string& robot, const std::string& name) {
    std::vector<RunningController*> found;
    for (RunningController& each : m_controllers)
        if (!each.removed && each.view->name == robot && (name.empty() || each.spec().name == name)) found.push_back(&each);
    return found;
}

RunningController* ControllerSet::controllerOf(const std::string& robot, const std::string& name) {
    const std::vector<RunningController*> found = controllersOf(robot, name);
    return found.empty() ? nullptr : found.front();
}

/// Also holds for controllers that come later.
Status ControllerSet::apply(const HoldCommand& hold) {
    std::set<Holder>& holders = m_holders[hold.robot];
    if (hold.held) holders.insert(hold.holder);
    else holders.erase(hold.holder);
    for (RunningController* controller : controllersOf(hold.robot)) controller->held = !holders.empty();
    return {};
}

/// Nothing if the object is not a controller.
std::optional<Status> ControllerSet::set(const PropertyCommand& command) {
    const std::size_t slash = command.object.find('/');
    if (slash == std::string::npos) return std::nullopt;
    const auto meant = controllersOf(command.object.substr(0, slash), command.object.substr(slash + 1));
    if (meant.empty()) return std::nullopt;
    return meant.front()->set(command, isStopped(*meant.front()), m_context.calls);
}

Status ControllerSet::apply(const RestartCommand& restart) {
    const std::vector<RunningController*> chosen = controllersOf(restart.robot, restart.controller);
    if (chosen.empty()) return Error{Code::NoSuchPath, restart.robot + " has no controller " + restart.controller};
    const auto processOf = [](const RunningController& controller) {
        const ControllerFault* fault = controller.backend->fault();
        return fault ? fault->process : std::string();
    };
    std::set<std::string> processes;
    for (const RunningController* controller : chosen) processes.insert(processOf(*controller));
    processes.erase(std::string());
    const auto isMeant = [&](RunningController& c) {
        return std::ranges::find(chosen, &c) != chosen.end() || (!c.removed && processes.contains(processOf(c)));
    };
    std::vector<RunningController*> meant;
    for (RunningController& controller : m_controllers)
        if (isMeant(controller)) meant.push_back(&controller);
    for (RunningController* controller : meant)
        if (startAgain(*controller))
            m_context.say(controller->view->name, TRUNDLE_INFO, "the controller " + controller->spec().name + " was started again");
    stopFaulty(); // a crash in setup ends the process of other robots too
    return {};
}

Status ControllerSet::apply(const StopCommand& stop) {
    for (const RunningController* controller : controllersOf(stop.robot, stop.controller)) {
        if (isStopped(*controller)) continue;
        m_stopped.push_back({controller->robot, controller->spec().name, m_context.world.time(), {}, true});
        m_context.say(stop.robot, TRUNDLE_INFO, "the controller " + controller->spec().name + " was stopped");
        setItsCommandsToZero(*controller);
    }
    return {};
}

void ControllerSet::forgetStop(const RunningController& controller) {
    std::erase_if(m_stopped, [&](const StoppedController& stopped) {
        return stopped.robot == controller.robot && stopped.controller == controller.spec().name;
    });
}

/// From its setup, in a new process if the old one has ended, with the live values that it had.
bool ControllerSet::startAgain(RunningController& controller) {
    forgetStop(controller);
    controller.called = controller.slow = false;
    ++controller.cost.restarts;
    const Status started = controller.start(m_context.world, outputsOf(indexOf(controller)), m_context.calls);
    if (started)
        for (const Error& refused : controller.setLiveValues(m_context.calls))
            m_context.say({}, TRUNDLE_ERROR, "command refused: " + refused.message);
    if (started || controller.backend->fault()) return !controller.backend->fault(); // which is reported by stopFaulty()
    m_stopped.push_back(
        {controller.robot, controller.spec().name, m_context.world.time(), {started.error().message, {}, {}, true}});
    m_context.say(controller.view->name, TRUNDLE_ERROR, started.error().message);
    setItsCommandsToZero(controller);
    return false;
}

/// What its code hands over to the new one. All are asked before the first is replaced: they may share a process.
std::string ControllerSet::stateOf(RunningController& controller) {
    if (isStopped(controller) || controller.backend->fault()) return {};
    Result<std::string> state = controller.saveState(m_context.calls);
    if (state) return std::move(state).value();
    m_context.say(controller.view->name, TRUNDLE_WARNING,
                  "no state is handed over: " + state.error().message);
    return {};
}

/// Without the state if the new code does not take it.
bool ControllerSet::startFrom(RunningController& controller, const std::string& state) {
    if (!startAgain(controller)) return false;
    if (state.empty()) return true;
    const Status loaded = controller.loadState(state, m_context.calls);
    if (loaded) return true;
    m_context.say(controller.view->name, TRUNDLE_WARNING,
                  "the state of the old code is not used: " + loaded.error().message);
    return startAgain(controller);
}

Status ControllerSet::apply(const ReloadCommand& reload) {
    ++m_requests;
    std::set<std::string> said;
    std::vector<std::string> states;
    const auto isMeant = [&](const RunningController& c) {
        return !c.removed && (reload.module.empty() || c.backend->module() == reload.module);
    };
    for (RunningController& controller : m_controllers)
        states.push_back(isMeant(controller) ? stateOf(controller) : std::string());
    std::vector<RunningController*> renewed;
    for (RunningController& controller : m_controllers) {
        if (!isMeant(controller)) continue;
        const MonitoredCall call(m_context.calls, controller.target, "load");
        if (const Status done = controller.backend->renew(m_requests); done) {
            m_claims.forget(controller.robot, indexOf(controller)); // another one's new code may have its commands
            renewed.push_back(&controller);
        } else if (said.insert(controller.spec().kind + done.error().message).second) {
            m_context.say(controller.view->name, TRUNDLE_ERROR,
                          "the controller " + controller.spec().kind + " continues with its old code: " + done.error().message);
        }
    }
    for (RunningController* controller : renewed) {
        const std::string library = controller->backend->module();
        if (startFrom(*controller, states[indexOf(*controller)]))
            m_context.say(controller->view->name, TRUNDLE_INFO,
                          "the controller " + controller->spec().name + " has the new code of " + library);
    }
    stopFaulty();
    return {};
}

bool ControllerSet::isStopped(const RunningController& controller) const {
    return std::ranges::any_of(m_stopped, [&](const StoppedController& stopped) {
        return stopped.robot == controller.robot && stopped.controller == controller.spec().name;
    });
}

/// Announces all updates of this tick before the first, so that a host process gets them together.
void ControllerSet::prepareUpdates(std::uint64_t tick, double time) {
    for (RunningController& controller : m_controllers) {
        controller.due = !controller.removed && controller.schedule.due(tick) && !controller.held && !hasEnded(m_context.world, controller.robot) &&
                         !isStopped(controller);
        if (controller.due) controller.prepare(tick, time);
    }
}

Status ControllerSet::update(RunningController& controller, std::uint64_t tick, double time) {
    const Status done = controller.update(tick, time, m_context.calls, m_context.measures);
    // Once for each controller. The time depends on the machine, so it goes to the console and affects nothing.
    if (const auto slow = controller.takeSlow())
        m_context.say(controller.view->name, TRUNDLE_WARNING, slowText(controller.spec(), *slow, controller.budget));
    return done;
}

/// After a fault of one controller: its commands become 0. Those whose controllers shared its process continue in a new one.
/// That may have a fault too, but each stops one controller more, so this ends.
void ControllerSet::stopFaulty() {
    for (bool again = true; std::exchange(again, false);)
        for (RunningController& controller : m_controllers) {
            const ControllerFault* fault = controller.removed ? nullptr : controller.backend->fault();
            if (!fault || isStopped(controller)) continue;
            again = true;
            if (!fault->isOwn && !m_ending) {
                goOnInNewProcess(controller);
                continue;
            }
            reportFault(controller);
            setItsCommandsToZero(controller);
        }
}

void ControllerSet::goOnInNewProcess(RunningController& controller) {
    const std::string reason = controller.backend->fault()->reason;
    if (!startAgain(controller)) return;
    m_context.warnings.push_back(faultDiagnostic(Severity::Warning, m_context.world.time(),
                                                 reason + "; it was started again in a new process, without what it had stored",
                                                 controller));
}

void ControllerSet::reportFault(const RunningController& controller) {
    const ControllerFault& fault = *controller.backend->fault();
    const double time = tickTime(m_context.world.ticks(), experiment().settings.tick);
    m_stopped.push_back({controller.robot, controller.spec().name, time, fault});
    m_context.warnings.push_back(faultDiagnostic(
        Severity::Error, time, fault.reason + (m_ending ? "" : "; the run continues without it"), controller, fault.place));
}

/// A destructor may have a fault too.
void ControllerSet::stop() {
    m_ending = true;
    for (RunningController& controller : m_controllers) {
        if (controller.removed) continue;
        controller.stop(m_context.calls);
        const ControllerFault* fault = controller.backend->fault();
        if (fault && fault->isOwn && !isStopped(controller)) reportFault(controller);
    }
}

std::optional<std::pair<Error, SourceRange>> ControllerSet::think() {
    const std::uint64_t tick = m_context.world.ticks();
    const double time = m_context.world.time();
    prepareUpdates(tick, time);
    m_apart.run(m_controllers, m_context.world, m_context.calls, tick, time);
    for (RunningController& controller : m_controllers)
        while (controller.due && !isStopped(controller)) { // again if it was started in a new process
            const Status done = update(controller, tick, time);
            if (done) break;
            if (!controller.backend->fault()) {
                Error failed = done.error();
                failed.message.insert(0, atTime(time));
                return std::pair(std::move(failed), controller.spec().nameRange);
            }
            stopFaulty();
        }
    return std::nullopt;
}

std::vector<const ControllerSpec*> ControllerSet::specsOf(const std::string& robot) const {
    std::vector<const ControllerSpec*> specs;
    for (const RunningController& each : m_controllers)
        if (!each.removed && each.view->name == robot) specs.push_back(&each.spec());
    return specs;
}

std::vector<ControllerCost> ControllerSet::costs() const {
    std::vector<ControllerCost> all;
    for (const RunningController& controller : m_controllers)
        if (!controller.removed) all.push_back(controller.costNow());
    return all;
}

} // namespace trundle
