#include "run/experiment_runner.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <trundle/abi.h>

#include "base/clean_text.h"
#include "control/medium_radios.h"
#include "run/command_signals.h"
#include "run/logs/log_kinds.h"
#include "schema/value_words.h"

namespace trundle {
namespace {

constexpr std::size_t kMaxControllerErrors = 20; // equal errors of several robots count once
constexpr std::size_t kMaxControllerLogs = 1000;
constexpr std::size_t kLongestReason = 1000; // bytes

CallTarget targetOf(const RobotSpec& robot, std::size_t index) {
    const std::string& kind = robot.controller->kind;
    return {"the controller " + kind + " of " + robot.name, robot.name, kind, {}, static_cast<std::uint32_t>(index)};
}

/// The number of a log that a controller opens; -1: refused, with a message.
int openControllerLog(LogFolder& folder, std::vector<LogFile*>& logs, const std::string& fileName,
                      const std::function<void(const std::string& text)>& refuse) {
    if (logs.size() >= kMaxControllerLogs) {
        refuse("no more than 1000 logs may be opened by controllers");
        return -1;
    }
    const Result<LogFile*> file = folder.create(fileName);
    if (!file) {
        refuse(file.error().message);
        return -1;
    }
    logs.push_back(file.value());
    return static_cast<int>(logs.size() - 1);
}

std::vector<std::string> writtenFiles(const LogFolder& folder) {
    std::vector<std::string> paths;
    for (const auto& file : folder.files())
        if (!file->failure()) paths.push_back(file->path());
    return paths;
}

Diagnostic faultDiagnostic(Severity severity, double time, const std::string& text, SourceRange range) {
    return {severity, Code::ControllerFailed, "at t = " + numberText(time) + " s " + text, range, {}, {}, {}};
}

std::string droppedText(std::size_t lines) {
    return codeName(Code::DroppedLines) + ": \u2026 " + std::to_string(lines) + (lines == 1 ? " line dropped" : " lines dropped");
}

std::string slowText(const RobotSpec& robot, double seconds, double budget) {
    return "an update of the controller " + robot.controller->name + " took " + numberText(std::round(1e4 * seconds) / 10) +
           " ms; its Budget is " + numberText(1e3 * budget) + " ms";
}

} // namespace

ExperimentRunner::ExperimentRunner(std::unique_ptr<World> world, RunOptions options)
    : m_options(std::move(options)), m_world(std::move(world)), m_cameras(*m_world, m_options.pictures),
      m_folder(m_options.logFolder), m_reportsDropped(1, m_world->experiment().settings.tick) {
    if (!m_options.calls) m_options.calls = std::make_shared<CallMonitor>();
    (void)m_reportsDropped.due(0);
    m_world->setDeviceText(
        [this](const std::string& device, int severity, const std::string& text) { addMessage(device, severity, text); });
}

void ExperimentRunner::addMessage(const std::string& who, int severity, const std::string& text) {
    if (!m_options.console) return;
    const std::string_view part = m_console.pass(who, m_world->ticks(), text);
    if (!part.empty() || text.empty())
        m_options.console(tickTime(m_world->ticks(), experiment().settings.tick), who, severity, cleanText(part));
}

void ExperimentRunner::reportDropped() {
    for (const auto& [who, lines] : m_console.takeDropped()) say(who, TRUNDLE_WARNING, droppedText(lines));
}

Status ExperimentRunner::fail(const Error& error, SourceRange range) {
    if (!m_failure) m_failure = Diagnostic{Severity::Error, error.code, error.message, range, {}, {}, {}};
    return error;
}

// ---- start ----

ControllerOutputs ExperimentRunner::outputsFor(const RobotSpec& robot) {
    ControllerOutputs outputs;
    outputs.finish = [this, &robot](const std::string& reason) {
        if (!m_finishAsked) m_finishAsked = RunFinish{robot.name, robot.controller->name, reason.substr(0, kLongestReason), 0};
    };
    outputs.print = [this, name = robot.name](int severity, const std::string& text) { addMessage(name, severity, text); };
    outputs.openLog = [this, name = robot.name](const std::string& fileName) {
        return openControllerLog(m_folder, m_controllerLogs, fileName,
                                 [&](const std::string& text) { addMessage(name, TRUNDLE_ERROR, text); });
    };
    outputs.writeLog = [this](int log, std::string_view bytes) {
        if (log >= 0 && static_cast<std::size_t>(log) < m_controllerLogs.size())
            m_controllerLogs[static_cast<std::size_t>(log)]->write(bytes);
    };
    m_pictures.addTo(outputs, robot.name);
    if (Medium* medium = m_world->medium()) outputs.radios = radiosOf(*medium);
    return outputs;
}

void ExperimentRunner::startControllers(const BackendFactory& backends, Diagnostics& diagnostics) {
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
                                 m_options.calls->add(targetOf(robots[i], i)), spec.number("Budget")});
        const MonitoredCall call(*m_options.calls, m_controllers.back().target, "setup");
        const Status started = m_controllers.back().backend->start(m_world->layout(), m_world->block(), outputsFor(robots[i]));
        if (!started) report(started.error(), spec);
    }
}

void ExperimentRunner::openLogs(Diagnostics& diagnostics) {
    std::set<std::string> said; // report a folder that cannot be written once, not for each log
    for (const ComponentSpec& spec : experiment().logs) {
        const std::size_t errorsBefore = diagnostics.errorCount();
        std::unique_ptr<Log> log = makeLog(spec, *m_world, diagnostics);
        if (!log || diagnostics.errorCount() > errorsBefore || m_options.logFolder.empty()) continue;
        const Result<LogFile*> file = m_folder.create(logFileName(spec));
        if (!file) {
            if (said.insert(file.error().message).second)
                diagnostics.error(file.error().code, spec.nameRange, file.error().message);
            continue;
        }
        log->usePictures([this, &spec](const PictureOptions& pictureOptions, const std::string& name) {
            return m_pictures.saveFor(spec, pictureOptions, name);
        });
        m_rows.clear();
        log->header(m_rows);
        file.value()->write(m_rows);
        m_logs.push_back(
            {std::move(log), file.value(), Schedule(spec.number("Interval"), experiment().settings.tick), spec.nameRange});
    }
    if (const Status written = writeLogs(); !written && m_failure) diagnostics.append({*m_failure});
    closeFinish();
}

// ---- tick ----

void ExperimentRunner::command(decltype(Command::what) what) { m_commands.push_back({m_world->ticks(), std::move(what)}); }

Status ExperimentRunner::apply(const Command& command) {
    if (const auto* push = std::get_if<PushCommand>(&command.what)) return m_world->push(push->body, push->force, push->point);
    if (const auto* place = std::get_if<PlaceCommand>(&command.what)) return m_world->place(place->robot, place->pose);
    if (const auto* signal = std::get_if<SignalCommand>(&command.what)) return setSignal(*m_world, *signal);
    if (const auto* hold = std::get_if<HoldCommand>(&command.what)) return apply(*hold);
    if (const auto* restart = std::get_if<RestartCommand>(&command.what)) return apply(*restart);
    if (const auto* reload = std::get_if<ReloadCommand>(&command.what)) return apply(*reload);
    if (const auto* stop = std::get_if<StopCommand>(&command.what)) return apply(*stop);
    if (const auto* surface = std::get_if<SurfaceCommand>(&command.what)) return m_world->setSurface(surface->surface);
    return apply(std::get<PropertyCommand>(command.what));
}

ExperimentRunner::Controller* ExperimentRunner::controllerOf(const std::string& robot) {
    const auto it =
        std::ranges::find_if(m_controllers, [&](const Controller& c) { return experiment().robots[c.robot].name == robot; });
    return it == m_controllers.end() ? nullptr : &*it;
}

/// Ignored for a robot without a controller.
Status ExperimentRunner::apply(const HoldCommand& hold) {
    if (Controller* controller = controllerOf(hold.robot)) controller->held = hold.held;
    return {};
}

Status ExperimentRunner::apply(const PropertyCommand& command) {
    const std::size_t slash = command.object.find('/');
    Controller* controller = controllerOf(command.object.substr(0, slash));
    const bool meant = controller && slash != std::string::npos &&
                       experiment().robots[controller->robot].controller->name == command.object.substr(slash + 1);
    if (meant) {
        const MonitoredCall call(*m_options.calls, controller->target, "set");
        return controller->backend->set(command.property, command.value);
    }
    return m_world->setProperty(command.object, command.property, command.value);
}

Status ExperimentRunner::apply(const RestartCommand& restart) {
    Controller* chosen = controllerOf(restart.robot);
    if (!chosen) return Error{Code::NoSuchPath, restart.robot + " has no controller"};
    const ControllerFault* fault = chosen->backend->fault();
    const std::string process = fault ? fault->process : std::string();
    for (Controller& controller : m_controllers) {
        const ControllerFault* other = controller.backend->fault();
        if (&controller != chosen && (process.empty() || !other || other->process != process)) continue;
        const RobotSpec& robot = experiment().robots[controller.robot];
        if (startAgain(controller)) say(robot.name, TRUNDLE_INFO, "the controller " + robot.controller->name + " was started again");
    }
    stopFaulty(); // a crash in setup ends the process of other robots too
    return {};
}

Status ExperimentRunner::apply(const StopCommand& stop) {
    const Controller* controller = controllerOf(stop.robot);
    if (!controller || isStopped(*controller)) return {};
    const RobotSpec& robot = experiment().robots[controller->robot];
    m_stopped.push_back({controller->robot, m_world->time(), {}, true});
    say(robot.name, TRUNDLE_INFO, "the controller " + robot.controller->name + " was stopped");
    setCommandsToZero(*m_world, robot);
    return {};
}

/// From its setup, in a new process if the old one has ended.
bool ExperimentRunner::startAgain(Controller& controller) {
    std::erase_if(m_stopped, [&](const StoppedController& stopped) { return stopped.robot == controller.robot; });
    controller.called = controller.slow = false;
    ++controller.cost.restarts;
    const RobotSpec& robot = experiment().robots[controller.robot];
    const MonitoredCall call(*m_options.calls, controller.target, "setup");
    const Status started = controller.backend->start(m_world->layout(), m_world->block(), outputsFor(robot));
    if (started || controller.backend->fault()) return started.ok(); // the fault is reported by stopFaulty()
    m_stopped.push_back({controller.robot, m_world->time(), {started.error().message, {}, {}, true}});
    say(robot.name, TRUNDLE_ERROR, started.error().message);
    setCommandsToZero(*m_world, robot);
    return false;
}

Status ExperimentRunner::apply(const ReloadCommand& reload) {
    std::set<std::string> said;
    for (Controller& controller : m_controllers) {
        const std::string library = controller.backend->module();
        if (!reload.module.empty() && library != reload.module) continue;
        const RobotSpec& robot = experiment().robots[controller.robot];
        const MonitoredCall call(*m_options.calls, controller.target, "load");
        if (const Status renewed = controller.backend->renew(m_applied + 1); !renewed) {
            if (said.insert(robot.controller->kind + renewed.error().message).second)
                say(robot.name, TRUNDLE_ERROR, "the controller " + robot.controller->kind + " continues with its old code: " + renewed.error().message);
        } else if (startAgain(controller)) {
            say(robot.name, TRUNDLE_INFO, "the controller " + robot.controller->name + " has the new code of " + library);
        }
    }
    stopFaulty();
    return {};
}

void ExperimentRunner::applyCommands() {
    for (; m_applied < m_commands.size(); ++m_applied)
        if (const Status done = apply(m_commands[m_applied]); !done)
            addMessage("", TRUNDLE_ERROR, "command refused: " + done.error().message);
}

bool ExperimentRunner::isStopped(const Controller& controller) const {
    return std::ranges::find(m_stopped, controller.robot, &StoppedController::robot) != m_stopped.end();
}

/// Announces all updates of this tick before the first, so that a host process gets them together.
void ExperimentRunner::prepareUpdates(std::uint64_t tick, double time) {
    for (Controller& controller : m_controllers) {
        controller.due = controller.schedule.due(tick) && !controller.held && !hasEnded(*m_world, controller.robot) &&
                         !isStopped(controller);
        if (controller.due) controller.prepare(tick, time);
    }
}

Status ExperimentRunner::update(Controller& controller, std::uint64_t tick, double time) {
    const Status done = controller.update(tick, time, *m_options.calls, m_options.measuresControllers);
    // Once for each controller. The time depends on the machine, so it goes to the console and affects nothing.
    const RobotSpec& robot = experiment().robots[controller.robot];
    if (const auto slow = controller.takeSlow()) say(robot.name, TRUNDLE_WARNING, slowText(robot, *slow, controller.budget));
    return done;
}

/// After a fault of one controller: its robot gets commands of 0. Those whose controllers shared its process continue in a new one.
/// That may have a fault too, but each stops one controller more, so this ends.
void ExperimentRunner::stopFaulty() {
    for (bool again = true; std::exchange(again, false);)
        for (Controller& controller : m_controllers) {
            const ControllerFault* fault = controller.backend->fault();
            if (!fault || isStopped(controller)) continue;
            again = true;
            if (!fault->isOwn && !m_finished) {
                goOnInNewProcess(controller);
                continue;
            }
            reportFault(controller);
            setCommandsToZero(*m_world, experiment().robots[controller.robot]);
        }
}

void ExperimentRunner::goOnInNewProcess(Controller& controller) {
    const std::string reason = controller.backend->fault()->reason;
    if (!startAgain(controller)) return;
    m_warnings.push_back(faultDiagnostic(Severity::Warning, m_world->time(),
                                         reason + "; it was started again in a new process, without what it had stored",
                                         experiment().robots[controller.robot].controller->nameRange));
}

void ExperimentRunner::reportFault(const Controller& controller) {
    const ControllerFault& fault = *controller.backend->fault();
    const double time = tickTime(m_world->ticks(), experiment().settings.tick);
    m_stopped.push_back({controller.robot, time, fault});
    const SourceRange range = experiment().robots[controller.robot].controller->nameRange;
    m_warnings.push_back(faultDiagnostic(
        Severity::Error, time, fault.reason + (m_finished ? "" : "; the run continues without it"), range));
}

/// At the end of the run; a destructor may have a fault too.
void ExperimentRunner::stopControllers() {
    for (Controller& controller : m_controllers) {
        const MonitoredCall call(*m_options.calls, controller.target, "destructor");
        controller.backend->stop();
        const ControllerFault* fault = controller.backend->fault();
        if (fault && fault->isOwn && !isStopped(controller)) reportFault(controller);
    }
}

Status ExperimentRunner::think() {
    const std::uint64_t tick = m_world->ticks();
    const double time = m_world->time();
    prepareUpdates(tick, time);
    for (Controller& controller : m_controllers)
        while (controller.due && !isStopped(controller)) { // again if it was started in a new process
            const Status done = update(controller, tick, time);
            if (done) break;
            if (!controller.backend->fault()) return fail(done.error(), experiment().robots[controller.robot].controller->nameRange);
            stopFaulty();
        }
    return {};
}

Status ExperimentRunner::writeLogs() {
    const std::uint64_t tick = m_world->ticks();
    const double time = tickTime(tick, experiment().settings.tick);
    for (OpenLog& open : m_logs) {
        if (open.schedule.due(tick)) {
            m_rows.clear();
            open.log->rows(*m_world, time, m_rows);
            open.file->write(m_rows);
        }
        if (open.file->failure()) return fail(*open.file->failure(), open.range);
    }
    for (LogFile* file : m_controllerLogs)
        if (file->failure()) return fail(*file->failure(), {});
    return {};
}

Status ExperimentRunner::tick() {
    if (m_failure) return Error{m_failure->code, m_failure->message};
    m_options.calls->recordTicks(m_world->ticks(), m_world->time());
    applyCommands();
    if (Status done = think(); !done) return done;
    const Status ticked = m_world->tick();
    m_worldWarnings.update(*m_world, m_warnings);
    if (!ticked) {
        const Fault* fault = m_world->fault();
        return fail(ticked.error(), fault ? fault->range : SourceRange{});
    }
    m_cameras.afterTick();
    if (m_reportsDropped.due(m_world->ticks())) reportDropped();
    if (Status done = writeLogs(); !done) return done;
    closeFinish();
    return {};
}

/// Ends a run requested by finish(), only after a complete tick with its log rows.
void ExperimentRunner::closeFinish() {
    if (!m_finishAsked || m_finish) return;
    m_finish = m_finishAsked;
    m_finish->time = tickTime(m_world->ticks(), experiment().settings.tick);
}

void ExperimentRunner::flushLogs() {
    for (const auto& file : m_folder.files()) {
        file->flush();
        if (file->failure()) (void)fail(*file->failure(), {});
    }
}

Status ExperimentRunner::finish() {
    if (m_finished) return m_failure ? Status(Error{m_failure->code, m_failure->message}) : Status();
    m_finished = true;
    stopControllers();
    reportDropped();
    for (const auto& file : m_folder.files())
        if (const Status closed = file->close(); !closed) (void)fail(closed.error(), {});
    m_folder.settle();
    return m_failure ? Status(Error{m_failure->code, m_failure->message}) : Status();
}

std::vector<ControllerCost> ExperimentRunner::controllerCosts() const {
    std::vector<ControllerCost> costs;
    for (const Controller& controller : m_controllers) costs.push_back(controller.costNow());
    return costs;
}

std::vector<std::string> ExperimentRunner::logFiles() const { return writtenFiles(m_folder); }

std::unique_ptr<Runner> Runner::create(std::shared_ptr<const ExperimentSpec> experiment, const DeviceCode& devices,
                                       const BackendFactory& backends, RunOptions options, Diagnostics& diagnostics) {
    const std::size_t errorsBefore = diagnostics.errorCount();
    checkLogs(*experiment, diagnostics);
    if (diagnostics.errorCount() > errorsBefore) return nullptr;
    if (!options.calls) options.calls = std::make_shared<CallMonitor>();
    std::unique_ptr<World> world = World::build(std::move(experiment), devices, diagnostics, options.calls);
    if (!world || diagnostics.errorCount() > errorsBefore) return nullptr;
    if (options.replaceWorld) world = options.replaceWorld(std::move(world), diagnostics);
    if (!world || diagnostics.errorCount() > errorsBefore) return nullptr;

    auto runner = std::make_unique<ExperimentRunner>(std::move(world), std::move(options));
    runner->startControllers(backends, diagnostics);
    if (diagnostics.errorCount() == errorsBefore) runner->openLogs(diagnostics);
    if (diagnostics.errorCount() > errorsBefore) return nullptr;
    return runner;
}

} // namespace trundle
