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

constexpr std::size_t kMaxControllerLogs = 1000;
constexpr std::size_t kLongestReason = 1000; // bytes

RunOptions withMonitor(RunOptions options) {
    if (!options.calls) options.calls = std::make_shared<CallMonitor>();
    return options;
}

std::vector<std::string> writtenFiles(const LogFolder& folder) {
    std::vector<std::string> paths;
    for (const auto& file : folder.files())
        if (!file->failure()) paths.push_back(file->path());
    return paths;
}

std::string droppedText(std::size_t lines) {
    return codeName(Code::DroppedLines) + ": \u2026 " + std::to_string(lines) + (lines == 1 ? " line dropped" : " lines dropped");
}

} // namespace

ExperimentRunner::ExperimentRunner(std::unique_ptr<World> world, RunOptions options)
    : m_options(withMonitor(std::move(options))), m_world(std::move(world)), m_cameras(*m_world, m_options.pictures),
      m_folder(m_options.logFolder),
      m_controllers({*m_world, *m_options.calls, m_warnings, [this](const RobotSpec& robot, const ControllerSpec& controller) { return outputsFor(robot, controller); },
                     [this](const std::string& who, int severity, const std::string& text) { say(who, severity, text); },
                     m_options.measuresControllers}),
      m_reportsDropped(1, m_world->experiment().settings.tick) {
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

ExperimentRunner::ControllerLog* ExperimentRunner::controllerLog(const std::string& fileName) {
    const Result<std::string> clean = cleanLogName(fileName);
    const auto found = std::ranges::find_if(m_controllerLogs,
                                            [&](const ControllerLog& log) { return clean && log.file->name() == clean.value(); });
    return found == m_controllerLogs.end() ? nullptr : &*found;
}

/// A file of the experiment or of a controller.
Result<LogFile*> ExperimentRunner::createLog(const std::string& fileName) {
    if (const ControllerLog* log = controllerLog(fileName))
        return Error{Code::LogUnwritable,
                     log->file->name() + " is already written by the controller " + log->controller + " of " + log->robot};
    return m_folder.create(fileName);
}

/// The number of a log that a controller opens; -1: refused, with a message. One that is started again continues its own files.
int ExperimentRunner::openControllerLog(ControllerLog asked, const std::string& fileName) {
    ControllerLog* own = controllerLog(fileName);
    if (own && own->robot == asked.robot && own->controller == asked.controller && own->start != asked.start) {
        own->start = asked.start;
        return static_cast<int>(own - m_controllerLogs.data());
    }
    Result<LogFile*> file = Error{Code::LogUnwritable, "no more than 1000 logs may be opened by controllers"};
    if (m_controllerLogs.size() < kMaxControllerLogs) file = createLog(fileName);
    if (!file) {
        addMessage(asked.robot, TRUNDLE_ERROR, file.error().message);
        return -1;
    }
    asked.file = file.value();
    m_controllerLogs.push_back(std::move(asked));
    return static_cast<int>(m_controllerLogs.size() - 1);
}

/// Called for each start of the controller.
ControllerOutputs ExperimentRunner::outputsFor(const RobotSpec& robot, const ControllerSpec& controller) {
    ControllerOutputs outputs;
    outputs.finish = [this, &robot, &controller](const std::string& reason) {
        if (!m_finishAsked) m_finishAsked = RunFinish{robot.name, controller.name, reason.substr(0, kLongestReason), 0};
    };
    outputs.print = [this, name = robot.name](int severity, const std::string& text) { addMessage(name, severity, text); };
    const ControllerLog own{nullptr, robot.name, controller.name, ++m_starts};
    outputs.openLog = [this, own](const std::string& fileName) { return openControllerLog(own, fileName); };
    outputs.writeLog = [this](int log, std::string_view bytes) {
        if (log >= 0 && static_cast<std::size_t>(log) < m_controllerLogs.size())
            m_controllerLogs[static_cast<std::size_t>(log)].file->write(bytes);
    };
    m_pictures.addTo(outputs, robot.name);
    if (Medium* medium = m_world->medium()) outputs.radios = radiosOf(*medium);
    if (m_options.replaceOutputs) m_options.replaceOutputs(outputs);
    return outputs;
}

/// Files are made only when all logs can be written: a run that is refused leaves those of the last one.
void ExperimentRunner::openLogs(Diagnostics& diagnostics) {
    const std::size_t errorsBefore = diagnostics.errorCount();
    std::vector<std::pair<const ComponentSpec*, std::unique_ptr<RunLog>>> made;
    for (const ComponentSpec& spec : experiment().logs) made.emplace_back(&spec, makeLog(spec, *m_world, diagnostics));
    if (diagnostics.errorCount() > errorsBefore) return;
    std::set<std::string> said; // report a folder that cannot be written once, not for each log
    for (auto& [spec, log] : made) {
        if (!log || m_options.logFolder.empty()) continue;
        const Result<LogFile*> file = createLog(logFileName(*spec));
        if (!file) {
            if (said.insert(file.error().message).second)
                diagnostics.error(file.error().code, spec->nameRange, file.error().message);
            continue;
        }
        log->usePictures([this, spec = spec](const PictureOptions& pictureOptions, const std::string& name) {
            return m_pictures.saveFor(*spec, pictureOptions, name);
        });
        m_rows.clear();
        log->header(m_rows);
        file.value()->write(m_rows);
        m_logs.push_back(
            {std::move(log), file.value(), Schedule(spec->number("Interval"), experiment().settings.tick), spec->nameRange});
    }
    m_hasLogs = diagnostics.errorCount() == errorsBefore;
    if (const Status written = writeLogs(); !written && m_failure) diagnostics.append({*m_failure});
    closeFinish();
}

// ---- tick ----

void ExperimentRunner::command(decltype(Command::what) what) { m_commands.push_back({m_world->ticks(), std::move(what)}); }

Status ExperimentRunner::apply(const Command& command) {
    if (const auto* push = std::get_if<PushCommand>(&command.what)) return m_world->push(push->body, push->force, push->point);
    if (const auto* place = std::get_if<PlaceCommand>(&command.what)) return m_world->place(place->robot, place->pose);
    if (const auto* signal = std::get_if<SignalCommand>(&command.what)) return setSignal(*m_world, *signal);
    if (const auto* hold = std::get_if<HoldCommand>(&command.what)) return m_controllers.apply(*hold);
    if (const auto* restart = std::get_if<RestartCommand>(&command.what)) return m_controllers.apply(*restart);
    if (const auto* reload = std::get_if<ReloadCommand>(&command.what)) return m_controllers.apply(*reload);
    if (const auto* stop = std::get_if<StopCommand>(&command.what)) return m_controllers.apply(*stop);
    if (const auto* swap = std::get_if<SwapCommand>(&command.what)) return m_controllers.apply(*swap);
    if (const auto* surface = std::get_if<SurfaceCommand>(&command.what)) return m_world->setSurface(surface->surface);
    const auto& value = std::get<PropertyCommand>(command.what);
    const std::optional<Status> ofController = m_controllers.set(value);
    return ofController ? *ofController : m_world->setProperty(value.object, value.property, value.value);
}

void ExperimentRunner::applyCommands() {
    for (; m_applied < m_commands.size(); ++m_applied)
        if (const Status done = apply(m_commands[m_applied]); !done)
            addMessage("", TRUNDLE_ERROR, "command refused: " + done.error().message);
    if (m_options.keepsCommands) return;
    m_commands.clear();
    m_applied = 0;
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
    for (const ControllerLog& log : m_controllerLogs)
        if (log.file->failure()) return fail(*log.file->failure(), {});
    return {};
}

/// Before their Interval is over.
void ExperimentRunner::writeCollected() {
    for (OpenLog& open : m_logs) {
        m_rows.clear();
        open.log->collected(m_rows);
        open.file->write(m_rows);
    }
}

Status ExperimentRunner::tick() {
    if (m_failure) return Error{m_failure->code, m_failure->message};
    m_options.calls->recordTicks(m_world->ticks(), m_world->time());
    applyCommands();
    if (const auto failed = m_controllers.think()) return fail(failed->first, failed->second);
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
    writeCollected();
    for (const auto& file : m_folder.files()) {
        file->flush();
        if (file->failure()) (void)fail(*file->failure(), {});
    }
}

Status ExperimentRunner::finish() {
    if (m_finished) return m_failure ? Status(Error{m_failure->code, m_failure->message}) : Status();
    m_finished = true;
    m_controllers.stop();
    reportDropped();
    writeCollected();
    for (const auto& file : m_folder.files())
        if (const Status closed = file->close(); !closed) (void)fail(closed.error(), {});
    if (m_hasLogs) m_folder.settle();
    m_folder.release();
    return m_failure ? Status(Error{m_failure->code, m_failure->message}) : Status();
}

std::vector<std::string> ExperimentRunner::logFiles() const { return writtenFiles(m_folder); }

const StoppedController* stoppedBy(const Diagnostic& problem, const std::vector<StoppedController>& stopped) {
    if (problem.severity != Severity::Error) return nullptr; // one that was started again in a new process
    const auto found = std::ranges::find_if(stopped, [&](const StoppedController& each) {
        return problem.robot == each.robot && problem.controller == each.controller;
    });
    return found == stopped.end() ? nullptr : &*found;
}

std::unique_ptr<Runner> Runner::create(std::shared_ptr<const ExperimentSpec> experiment, const DeviceCode& devices,
                                       const BackendFactory& backends, RunOptions options, Diagnostics& diagnostics) {
    const std::size_t errorsBefore = diagnostics.errorCount();
    checkLogs(*experiment, diagnostics);
    if (diagnostics.errorCount() > errorsBefore) return nullptr;
    if (!options.calls) options.calls = std::make_shared<CallMonitor>();
    options.calls->beginRun();
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
