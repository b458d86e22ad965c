#include "editor/running/session.h"

#include <chrono>
#include <mutex>

#include <trundle/abi.h>

#include "control/module_store.h"
#include "editor/running/live_edits.h"
#include "editor/running/pose_overlay.h"
#include "project/objects/unplaced_configs.h"
#include "run/runner.h"

namespace trundle {
namespace {

constexpr int kFrameMs = 16, kWatchMs = 250, kValuesMs = 100;
constexpr double kRemarkablyLongS = 1;
constexpr std::chrono::milliseconds kLastWait(2000);

/// An arena alone has nothing that moves.
QString nothingToRun(const Document& document) {
    QStringList names;
    for (const Part* config : configsWithoutInstances(*document.loaded())) {
        if (config->kind && config->kind->name == "RobotConfig") return {}; // the preview runs it on a floor
        names.append(QString::fromStdString(config->name));
    }
    if (names.isEmpty()) return {};
    const QString why = RunSession::tr("There is nothing to run: this file describes %1 and places nothing. To run it, import "
                                       "the file in an experiment and drag it in from the Library.")
                            .arg(names.join(QStringLiteral(", ")));
    return document.isSample(document.path()) ? why + RunSession::tr(" Its card on the Welcome page does that.") : why;
}

} // namespace

/// Called by the run's thread to post readSnapshot() to the session. Shared by both; does nothing once the session is destroyed.
struct RunSession::Notifier {
    std::mutex lock;
    RunSession* session = nullptr;

    void notify() {
        const std::scoped_lock guard(lock);
        if (session)
            QMetaObject::invokeMethod(
                session, [s = session] { s->readSnapshot(); }, Qt::QueuedConnection);
    }
};

RunSession::RunSession(Document& document, Application& application, QObject* parent)
    : QObject(parent), m_document(document), m_application(application), m_preview(application),
      m_notifier(std::make_shared<Notifier>()) {
    m_notifier->session = this;
    m_frames.setInterval(kFrameMs);
    m_frames.setTimerType(Qt::PreciseTimer);
    connect(&m_frames, &QTimer::timeout, this, &RunSession::readSnapshot);
    m_watch.setInterval(kWatchMs);
    connect(&m_watch, &QTimer::timeout, this, &RunSession::watch);
    m_valuesPause.setInterval(kValuesMs);
    m_valuesPause.setSingleShot(true);
    connect(&m_valuesPause, &QTimer::timeout, this, [this] {
        if (m_valuesWait) showValues();
    });
    connect(this, &RunSession::stateChanged, this, &RunSession::showValues);
    connect(this, &RunSession::advanced, this, [this] {
        m_valuesWait = true;
        if (!m_valuesPause.isActive()) showValues();
    });
    connect(&document, &Document::opened, this, &RunSession::reset);
    connect(&document, &Document::opened, this, [this] {
        dropOwnLogs();
        setLogsAt({});
    });
    connect(&document, &Document::changed, this, &RunSession::followDocument);
}

RunSession::~RunSession() {
    {
        const std::scoped_lock guard(m_notifier->lock);
        m_notifier->session = nullptr;
    }
    leave();
    (void)waitForRuns();
    dropOwnLogs();
}

bool RunSession::endRuns() {
    reset();
    return waitForRuns();
}

bool RunSession::waitForRuns() const {
    const auto deadline = std::chrono::steady_clock::now() + kLastWait;
    return std::ranges::all_of(m_leaving, [&](const std::unique_ptr<LiveRun>& run) {
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - std::chrono::steady_clock::now());
        return run->waitUntilGone(std::max(left, std::chrono::milliseconds(0)));
    });
}

std::shared_ptr<const ExperimentSpec> RunSession::shown() const {
    const std::shared_ptr<const LoadedProject> loaded = m_preview.show(m_document);
    return loaded ? loaded->experiment : nullptr;
}

double RunSession::time() const { return m_snapshot ? m_snapshot->time : 0; }

double RunSession::realTimeFactor() const { return m_snapshot && m_state == RunState::Running ? m_snapshot->realTimeFactor : 0; }

double RunSession::notRespondingSeconds() const {
    const double busy = m_run ? m_run->busyS() : 0;
    return busy >= kRemarkablyLongS ? busy : 0;
}

QString RunSession::unresponsiveController() const {
    const auto turn = m_run ? m_run->turn() : std::nullopt;
    if (!turn || !m_built || *turn >= m_built->experiment->robots.size()) return {};
    const RobotSpec& robot = m_built->experiment->robots[*turn];
    return tr("%1's %2").arg(QString::fromStdString(robot.name),
                             QString::fromStdString(robot.controller ? robot.controller->kind : std::string()));
}

QString RunSession::notRespondingText() const {
    const double held = notRespondingSeconds();
    if (held <= 0) return {};
    const QString seconds = QString::number(held, 'f', 0), who = unresponsiveController();
    if (!who.isEmpty()) return tr("%1 has not responded for %2 s").arg(who, seconds);
    return m_state == RunState::Building ? tr("building for %1 s").arg(seconds) : tr("one tick takes %1 s so far").arg(seconds);
}

/// Updates the message about an unresponsive controller; the window itself stays responsive.
void RunSession::watch() {
    const QString text = notRespondingText();
    if (text == m_notRespondingText) return;
    m_notRespondingText = text;
    if (!unresponsiveController().isEmpty() && notRespondingSeconds() > 0 && !std::exchange(m_reportedNotResponding, true))
        addConsoleLine(
            TRUNDLE_WARNING,
            tr("%1 is not responding. Reset abandons it; you can continue editing and save").arg(unresponsiveController()));
    if (text.isEmpty()) m_reportedNotResponding = false;
    Q_EMIT notRespondingChanged();
}

QString RunSession::refusal() const {
    const std::shared_ptr<const LoadedProject>& loaded = m_document.loaded();
    if (!loaded) return tr("Nothing is open.");
    std::size_t errors = 0;
    const Diagnostic *error = nullptr, *module = nullptr; // the first of each
    for (const Diagnostic& d : loaded->diagnostics.all()) {
        // A text can be viewed without a module's kinds, but not run without its controller.
        if ((d.code == Code::ModuleNotTrusted || d.code == Code::ModuleUndescribed) && !module) module = &d;
        if (d.severity != Severity::Error) continue;
        ++errors;
        if (!error) error = &d;
    }
    if (module && module->code == Code::ModuleNotTrusted) { // the rest of the message is advice for the command line
        const QString why = QString::fromStdString(module->message);
        return tr("%1 To run it, trust the folder in the Controllers panel.")
            .arg(why.left(why.indexOf(QStringLiteral(", so its code"))) + u'.');
    }
    if (error) {
        const QString why = QString::fromStdString(error->message);
        return errors == 1 ? tr("The text has an error: %1").arg(why)
                           : tr("The text has %1 errors, the first: %2").arg(errors).arg(why);
    }
    return module ? QString::fromStdString(module->message) + u'.' : nothingToRun(m_document);
}

bool RunSession::describesOnly() const {
    const QString why = refusal();
    return !why.isEmpty() && m_document.loaded() && why == nothingToRun(m_document);
}

// ---- start and end ----

bool RunSession::reject(const QString& reason) {
    Q_EMIT refused(reason);
    return false;
}

bool RunSession::begin(bool running, std::uint64_t steps) {
    // A module rebuilt since the text was loaded may accept other values: the text is checked against its current description.
    if (const auto& loaded = m_document.loaded(); loaded && descriptionChanged(*loaded->experiment, *loaded->registry))
        m_document.readAgain();
    if (const QString why = refusal(); !why.isEmpty()) return reject(why);
    m_built = m_preview.show(m_document);
    m_experiment = m_built->experiment;
    m_sameRobots.begin(m_built);
    m_end.reset();
    m_problems.clear();
    LiveRun::Options options;
    takeOwnLogs();
    options.logFolder = logFolder();
    options.speed = m_speed;
    options.startsRunning = running;
    options.steps = steps;
    options.canContinue = true;
    options.contacts = m_contacts;
    options.radio = m_radio;
    options.changed = [bell = m_notifier] { bell->notify(); };
    options.after = m_leaving.empty() ? nullptr : m_leaving.back().get();
    Application* application = &m_application; // makeRunner() uses only members that outlive the window
    if (options.logFolder.empty() && !m_experiment->logs.empty())
        addConsoleLine(TRUNDLE_WARNING, tr("no logs are written: there is no folder for them"));
    setLogsAt(m_experiment->logs.empty() ? QString() : QString::fromStdString(options.logFolder.path()));
    m_run = std::make_unique<LiveRun>(
        [application, loaded = m_built](RunOptions runOptions, Diagnostics& problems) {
            return application->makeRunner(*loaded, std::move(runOptions), problems);
        },
        std::move(options));
    setState(RunState::Building);
    Q_EMIT experimentChanged();
    Q_EMIT problemsChanged();
    return true;
}

void RunSession::leave() {
    m_frames.stop();
    m_watch.stop();
    m_reportedNotResponding = false;
    if (!m_run) return;
    m_run->stop();
    m_leaving.push_back(std::move(m_run));
}

void RunSession::run() {
    const QString edits = canResume() ? waitingText() : QString();
    if (m_state == RunState::Ended && (!canResume() || needsReset())) reset();
    if (m_state == RunState::Start) {
        if (!begin(true) || edits.isEmpty()) return;
        const QString text = tr("Begins again from the start, with the edits of %1").arg(edits);
        addConsoleLine(TRUNDLE_INFO, text);
        Q_EMIT m_document.notice(text);
    } else if (m_run) {
        reportWaitingEdits();
        m_run->run();
    }
}

void RunSession::pause() {
    if (m_run) m_run->pause();
}

void RunSession::step() {
    if (m_state == RunState::Ended && !canResume()) return;
    if (m_state == RunState::Start) begin(false, 1);
    else {
        if (canResume()) reportWaitingEdits();
        m_run->step();
    }
}

void RunSession::runFor(double seconds) {
    if (m_state == RunState::Ended && !canResume()) return;
    const auto experiment = m_experiment ? m_experiment : shown();
    const std::uint64_t ticks = experiment ? ticksFor(seconds, experiment->settings.tick) : 0;
    if (m_state == RunState::Start) begin(false, ticks);
    else if (ticks > 0) m_run->step(ticks);
}

void RunSession::reset() {
    backToStart();
    forgetProblems();
}

void RunSession::backToStart() {
    if (m_state == RunState::Start) return;
    leave();
    m_built.reset();
    m_sameRobots.begin(nullptr);
    m_experiment.reset();
    m_layout.reset();
    m_reader.reset();
    m_live.reset();
    m_snapshot.reset();
    m_poses.reset();
    m_placed.clear();
    m_end.reset();
    m_driven.clear();
    const bool waited = needsReset(), wasNotResponding = !std::exchange(m_notRespondingText, {}).isEmpty();
    m_waiting.clear();
    setState(RunState::Start);
    if (wasNotResponding) Q_EMIT notRespondingChanged();
    Q_EMIT experimentChanged();
    if (waited) Q_EMIT waitingChanged();
    Q_EMIT advanced();
}

void RunSession::forgetProblems() {
    if (m_problems.empty()) return;
    m_problems.clear();
    Q_EMIT problemsChanged();
}

void RunSession::setSpeed(double factor) {
    if (!(factor >= 0) || factor > 1e6 || factor == m_speed) return;
    m_speed = factor;
    if (m_run) m_run->setSpeed(factor);
    Q_EMIT speedChanged();
}

void RunSession::setContactsEnabled(bool wanted) {
    m_contacts = wanted;
    if (m_run) m_run->setContactsEnabled(wanted);
}

void RunSession::setRadioEnabled(bool wanted) {
    m_radio = wanted;
    if (m_run) m_run->setRadioEnabled(wanted);
}

LiveRadio RunSession::takeRadio() { return m_run ? m_run->takeRadio() : LiveRadio(); }

void RunSession::setState(RunState state) {
    if (state == RunState::Running) m_frames.start();
    else m_frames.stop();
    if (state == RunState::Start || state == RunState::Ended) m_watch.stop();
    else if (!m_watch.isActive()) m_watch.start();
    if (state == m_state) return;
    m_state = state;
    Q_EMIT stateChanged();
}

// ---- reading the results of the run's thread ----

void RunSession::readSnapshot() {
    std::erase_if(m_leaving, [](const std::unique_ptr<LiveRun>& run) { return run->gone(); });
    if (!m_run) return;
    const LiveRun* const run = m_run.get();
    const LiveView view = m_run->view(); // before the reports: those of an ended run are complete then
    takeReports();
    if (m_run.get() != run) return; // a slot connected to the reports has reset the run
    if (!m_layout && (m_layout = view.layout)) {
        m_reader = std::make_unique<PoseReader>(*m_experiment, *m_layout);
        m_live = std::make_unique<LiveObjects>(m_built->experiment, m_layout, m_built->registry);
    }
    showSnapshot(view.snapshot);
    if (m_run.get() != run) return;
    switch (view.phase) {
    case LivePhase::Building: return setState(RunState::Building);
    case LivePhase::Running: return resume(RunState::Running);
    case LivePhase::Paused: return resume(RunState::Paused);
    case LivePhase::Ended: break;
    }
    if (m_state == RunState::Ended) return;
    m_end = m_run->end();
    if (m_end && m_end->failure) {
        for (const Diagnostic& d : m_end->problems) m_problems.push_back(d);
        if (m_end->problems.empty()) m_problems.push_back(*m_end->failure);
        Q_EMIT problemsChanged();
    }
    m_driven.clear();
    const std::optional<Diagnostic> failure = m_end ? m_end->failure : std::nullopt;
    if (failure) addConsoleLine(TRUNDLE_ERROR, QString::fromStdString(codeName(failure->code) + ": " + failure->message));
    if (m_end && m_layout) reportLogs();
    const bool neverBuilt = !m_layout;
    setState(RunState::Ended);
    if (failure) Q_EMIT ended(*failure);
    if (neverBuilt && m_state == RunState::Ended) backToStart(); // there is no world to show; the errors stay until the next edit
}

void RunSession::resume(RunState state) {
    if (canResume()) {
        const double end = m_end->time;
        m_end.reset();
        addConsoleLine(TRUNDLE_INFO, m_logsAt.isEmpty() ? tr("continues past its end at t = %1 s").arg(end)
                                                        : tr("continues past its end at t = %1 s, and so do its logs").arg(end));
    }
    setState(state);
}

void RunSession::takeReports() {
    const LiveLines taken = m_run->takeLines();
    std::vector<Diagnostic> warnings = m_run->takeWarnings();
    if (!taken.lines.empty() || taken.dropped > 0) Q_EMIT consoleLines(taken.lines, taken.dropped);
    if (warnings.empty()) return;
    m_problems.insert(m_problems.end(), std::make_move_iterator(warnings.begin()), std::make_move_iterator(warnings.end()));
    Q_EMIT problemsChanged();
}

void RunSession::showSnapshot(std::shared_ptr<const LiveSnapshot> snapshot) {
    if (!snapshot || !m_reader || snapshot == m_snapshot) return;
    m_snapshot = std::move(snapshot);
    if (m_snapshot->tick > m_placedTick) m_placed.clear();
    if (!m_placed.empty()) {
        auto moved = std::make_shared<LiveSnapshot>(*m_snapshot);
        moved->contacts = nullptr; // they belong to the previous poses
        moved->images.clear();
        moved->block = withPlaced(*m_layout, *m_snapshot->block, *m_experiment, m_placed);
        m_snapshot = std::move(moved);
    }
    auto poses = std::make_shared<BodyPoses>();
    m_reader->read(*m_snapshot->block, *poses);
    m_poses = std::move(poses);
    Q_EMIT advanced();
}

QString RunSession::finishText() const {
    if (!m_end || !m_end->finish) return {};
    const RunFinish& finish = *m_end->finish;
    const QString who = QString::fromStdString(finish.robot + "/" + finish.controller);
    const QString reason = QString::fromStdString(finish.reason).simplified();
    const QString when = QString::number(finish.time);
    return reason.isEmpty() ? tr("finished by %1 at t = %2 s").arg(who, when)
                            : tr("finished by %1 at t = %2 s: %3").arg(who, when, reason);
}

void RunSession::setLogsAt(const QString& folder) {
    if (folder == m_logsAt) return;
    m_logsAt = folder;
    Q_EMIT logsAtChanged();
}

void RunSession::addConsoleLine(int severity, const QString& text) {
    Q_EMIT consoleLines({{m_end ? m_end->time : time(), "", severity, text.toStdString()}}, 0);
}

// ---- document changes during a run ----

void RunSession::followDocument() {
    Q_EMIT refusalChanged();
    if (m_state == RunState::Start) forgetProblems(); // those of a run that could not be built
    if (!m_built || !m_run || !m_document.loaded()) return;
    m_sameRobots.follow(m_document.loaded());
    LiveEdits edits = liveEdits(*m_built, *m_experiment, *m_preview.show(m_document));
    for (auto& command : edits.commands) m_run->command(std::move(command));
    if (edits.experiment) {
        m_experiment = std::move(edits.experiment);
        Q_EMIT experimentChanged();
    }
    if (edits.waiting == m_waiting) return;
    m_waiting = std::move(edits.waiting);
    Q_EMIT waitingChanged();
}

bool RunSession::waitsForReset(const std::string& path) const {
    return std::ranges::any_of(m_waiting, [&](const std::string& waiting) {
        return path == waiting || (path.size() > waiting.size() && path.starts_with(waiting) && path[waiting.size()] == '.');
    });
}

} // namespace trundle
