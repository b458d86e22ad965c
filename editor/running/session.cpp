#include "editor/running/session.h"

#include <algorithm>
#include <chrono>
#include <mutex>

#include <trundle/abi.h>

#include "editor/running/live_edits.h"
#include "editor/widgets/name_list.h"
#include "run/runner.h"

namespace trundle {
namespace {

constexpr int kFrameMs = 16;
constexpr qsizetype kMaxNamed = 3;
constexpr std::chrono::milliseconds kLastWait(2000);

/// Console lines for robots that ended and joints that were closed again; a warning of pictures has a line of its own.
LiveLines faultLines(const std::vector<Diagnostic>& warnings, const LiveSnapshot* snapshot, const ExperimentSpec& experiment) {
    LiveLines lines;
    static const LiveSnapshot kNone;
    const LiveSnapshot& shown = snapshot ? *snapshot : kNone;
    for (const Diagnostic& warning : warnings) {
        if (warning.code != Code::BlowUp && warning.code != Code::ControllerFailed) continue;
        const int severity = warning.severity == Severity::Error ? TRUNDLE_ERROR : TRUNDLE_WARNING;
        std::vector<std::string> backtrace;
        LiveLine line{shown.time, {}, severity, codeName(warning.code) + ": " + warning.message};
        if (warning.robot) line.who = experiment.robots[*warning.robot].name;
        for (const RobotEnd& end : shown.ended)
            if (warning.code == Code::BlowUp && warning.robot == end.robot) line.time = end.fault.time;
        if (const StoppedController* stopped = stoppedBy(warning, shown.stopped)) {
            line.time = stopped->time;
            backtrace = stopped->fault.backtrace;
        }
        lines.lines.push_back(line);
        for (const std::string& frame : backtrace)
            lines.lines.push_back({line.time, line.who, severity, "  " + frame});
    }
    return lines;
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
    : QObject(parent), m_document(document), m_notifier(std::make_shared<Notifier>()),
      m_source(std::make_unique<RunSource>(document, application)), m_messages(std::make_unique<RunMessages>()),
      m_logs(std::make_unique<RunLogs>(document)), m_edits(std::make_unique<RunEdits>()),
      m_ended(std::make_unique<EndedRobots>(m_active, *m_edits)), m_values(std::make_unique<RunValues>(m_active, *m_edits)),
      m_responses(std::make_unique<ResponseWatch>(m_active, *m_messages)),
      m_robots(std::make_unique<RobotCommands>(m_active, *m_edits, *m_ended, *m_messages, document)),
      m_remote(std::make_unique<RemoteAccess>()) {
    m_notifier->session = this;
    m_frames.setInterval(kFrameMs);
    m_frames.setTimerType(Qt::PreciseTimer);
    connect(&m_frames, &QTimer::timeout, this, &RunSession::readSnapshot);
    connect(this, &RunSession::stateChanged, m_values.get(), &RunValues::stateChanged);
    connect(this, &RunSession::advanced, m_values.get(), &RunValues::advanced);
    connect(m_robots.get(), &RobotCommands::placed, this,
            [this] { showSnapshot(std::make_shared<LiveSnapshot>(*m_active.snapshot)); }); // the same tick with the new pose
    connect(m_remote.get(), &RemoteAccess::switched, this, &RunSession::serveOthers);
    connect(&document, &Document::opened, this, [this] {
        reset();
        m_logs->forget();
    });
    connect(&document.editedModel(), &EditedModel::changed, this, &RunSession::reset); // it runs something else from now on
    connect(&document, &Document::changed, this, &RunSession::followDocument);
}

RunSession::~RunSession() {
    {
        const std::scoped_lock guard(m_notifier->lock);
        m_notifier->session = nullptr;
    }
    leave();
    (void)waitForRuns();
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

// ---- start and end ----

bool RunSession::begin(bool running, std::uint64_t steps) {
    saveModules();
    m_source->readChangedModules();
    if (const QString why = m_source->refusal(); !why.isEmpty()) return m_messages->refuse(why);
    if (const QString old = m_source->outdatedModules(); !old.isEmpty()) warn(old);
    m_active.built = m_source->project();
    m_active.experiment = m_active.built->experiment;
    m_active.end.reset();
    m_edits->begin(m_active.built);
    m_messages->clearProblems();
    const bool hasLogs = !m_active.experiment->logs.empty();
    LiveRun::Options options;
    options.logFolder = m_logs->begin(hasLogs);
    options.speed = m_speed;
    options.startsRunning = running;
    options.steps = steps;
    options.canContinue = true;
    options.contacts = m_contacts;
    options.radio = m_radio;
    options.guest = m_remote->guestFor(m_document.path());
    options.changed = [bell = m_notifier] { bell->notify(); };
    options.after = m_leaving.empty() ? nullptr : m_leaving.back().get();
    Application* application = &m_source->application(); // makeRunner() uses only members that outlive the window
    if (options.logFolder.empty() && hasLogs)
        addConsoleLine(TRUNDLE_WARNING, tr("no logs are written: there is no folder for them"));
    m_active.live = std::make_unique<LiveRun>(
        [application, loaded = m_active.built](RunOptions runOptions, Diagnostics& problems) {
            return application->makeRunner(*loaded, std::move(runOptions), problems);
        },
        std::move(options));
    setState(RunState::Building);
    Q_EMIT experimentChanged();
    return true;
}

/// A run executes what is on disk; one that is resumed reloads what was saved (ModuleReload).
void RunSession::saveModules() {
    const std::vector<std::string> files = m_source->unsavedModules();
    if (files.empty()) return;
    QStringList shown;
    for (const std::string& file : files) shown += QString::fromStdString(m_document.texts().shown(file));
    const QString names = listed(shown, kMaxNamed);
    const Status saved = m_document.saving().save(files);
    if (saved) return addConsoleLine(TRUNDLE_INFO, tr("saved %1").arg(names));
    const QString text = tr("Runs without the unsaved edits of %1: %2").arg(names, QString::fromStdString(saved.error().message));
    warn(text);
}

void RunSession::warn(const QString& text) {
    addConsoleLine(TRUNDLE_WARNING, text);
    Q_EMIT m_document.notice(text);
}

/// Without a run there is nothing to serve: it is built, and waits.
void RunSession::serveOthers() {
    if (m_active.live) m_active.live->setGuest(m_remote->guestFor(m_document.path()));
    else if (m_remote->isOn() && m_document.isOpen()) begin(false);
}

/// Another program has set it.
void RunSession::followSpeed(double speed) {
    if (speed == m_speed) return;
    m_speed = speed;
    Q_EMIT speedChanged();
}

void RunSession::leave() {
    m_frames.stop();
    m_responses->leaveRun();
    if (!m_active.live) return;
    m_active.live->stop();
    m_leaving.push_back(std::move(m_active.live));
}

void RunSession::run() {
    const bool canResume = m_active.canResume();
    const QString edits = canResume ? m_edits->waitingText() : QString();
    if (state() == RunState::Ended && (!canResume || m_edits->needsReset())) reset();
    if (state() == RunState::Start) {
        if (!begin(true) || edits.isEmpty()) return;
        const QString text = tr("Begins again from the start, with the edits of %1").arg(edits);
        addConsoleLine(TRUNDLE_INFO, text);
        Q_EMIT m_document.notice(text);
    } else if (m_active.live) {
        saveModules();
        reportWaitingEdits();
        m_active.live->run();
    }
}

void RunSession::pause() {
    if (m_active.live) m_active.live->pause();
}

void RunSession::step() {
    if (state() == RunState::Ended && !m_active.canResume()) return;
    if (state() == RunState::Start) begin(false, 1);
    else {
        saveModules();
        if (m_active.canResume()) reportWaitingEdits();
        m_active.live->step();
    }
}

void RunSession::runFor(double seconds) {
    if (state() == RunState::Ended && !m_active.canResume()) return;
    const auto experiment = m_active.experiment ? m_active.experiment : m_source->shown();
    const std::uint64_t ticks = experiment ? ticksFor(seconds, experiment->settings.tick) : 0;
    if (state() == RunState::Start) begin(false, ticks);
    else if (ticks > 0) {
        saveModules();
        reportWaitingEdits();
        m_active.live->step(ticks);
    }
}

void RunSession::reset() {
    backToStart();
    m_messages->clearProblems();
}

void RunSession::backToStart() {
    if (state() == RunState::Start) return;
    leave();
    static_cast<RunResults&>(m_active) = {};
    m_ended->update();
    m_reader.reset();
    m_values->clear();
    m_robots->clear();
    m_edits->begin(nullptr);
    const bool waited = m_edits->clear(), wasNotResponding = m_responses->clear();
    setState(RunState::Start);
    if (wasNotResponding) Q_EMIT m_responses->changed();
    Q_EMIT experimentChanged();
    if (waited) Q_EMIT m_edits->changed();
    Q_EMIT advanced();
}

void RunSession::setSpeed(double factor) {
    if (!(factor >= 0) || factor > 1e6 || factor == m_speed) return;
    m_speed = factor;
    if (m_active.live) m_active.live->setSpeed(factor);
    Q_EMIT speedChanged();
}

void RunSession::enable(Extra what, bool wanted) {
    (what == Extra::Contacts ? m_contacts : m_radio) = wanted;
    if (!m_active.live) return;
    if (what == Extra::Contacts) m_active.live->setContactsEnabled(wanted);
    else m_active.live->setRadioEnabled(wanted);
}

LiveRadio RunSession::takeRadio() { return m_active.live ? m_active.live->takeRadio() : LiveRadio(); }

void RunSession::setState(RunState state) {
    if (state == RunState::Running) m_frames.start();
    else m_frames.stop();
    m_responses->setEnabled(state != RunState::Start && state != RunState::Ended);
    if (state == m_active.state) return;
    m_active.state = state;
    Q_EMIT stateChanged();
}

// ---- reading the results of the run's thread ----

void RunSession::readSnapshot() {
    std::erase_if(m_leaving, [](const std::unique_ptr<LiveRun>& run) { return run->gone(); });
    LiveRun* const run = m_active.live.get();
    if (!run) return;
    const auto wasReset = [&] { return m_active.live.get() != run; }; // by a slot connected to what is reported
    const LiveView view = run->view(); // before the reports: those of an ended run are complete then
    const LiveLines lines = run->takeLines();
    std::vector<Diagnostic> warnings = run->takeWarnings();
    if (m_remote->isOn()) followSpeed(run->speed());
    m_messages->add(lines);
    if (!warnings.empty()) // the snapshot that they are about was published before them
        m_messages->add(faultLines(warnings, run->view().snapshot.get(), *m_active.experiment));
    m_messages->addProblems(std::move(warnings));
    if (wasReset()) return;
    if (!m_active.layout && (m_active.layout = view.layout)) {
        m_reader = std::make_unique<PoseReader>(*m_active.experiment, *m_active.layout);
        m_values->begin();
    }
    showSnapshot(view.snapshot);
    if (wasReset()) return;
    switch (view.phase) {
    case LivePhase::Building: return setState(RunState::Building);
    case LivePhase::Running: return resume(RunState::Running);
    case LivePhase::Paused: return resume(RunState::Paused);
    case LivePhase::Ended:
        if (state() != RunState::Ended) endRun();
    }
}

void RunSession::endRun() {
    m_active.end = m_active.live->end();
    const std::optional<Diagnostic> failure = m_active.end ? m_active.end->failure : std::nullopt;
    if (failure)
        m_messages->addProblems(m_active.end->problems.empty() ? std::vector<Diagnostic>{*failure} : m_active.end->problems);
    m_robots->endDriving();
    if (failure) addConsoleLine(TRUNDLE_ERROR, QString::fromStdString(codeName(failure->code) + ": " + failure->message));
    if (m_active.end && m_active.layout) reportLogs();
    const bool neverBuilt = !m_active.layout;
    setState(RunState::Ended);
    if (failure) Q_EMIT ended(*failure);
    if (neverBuilt && failure)
        (void)m_messages->refuse(tr("The run cannot be built: %1").arg(QString::fromStdString(failure->message)));
    if (neverBuilt && state() == RunState::Ended) backToStart(); // there is no world to show; the errors stay until the next edit
}

void RunSession::resume(RunState state) {
    if (m_active.canResume()) {
        const double end = m_active.end->time;
        m_active.end.reset();
        addConsoleLine(TRUNDLE_INFO, m_logs->folder().isEmpty()
                                         ? tr("continues past its end at t = %1 s").arg(end)
                                         : tr("continues past its end at t = %1 s, and so do its logs").arg(end));
    }
    setState(state);
}

void RunSession::showSnapshot(std::shared_ptr<const LiveSnapshot> snapshot) {
    if (!snapshot || !m_reader || snapshot == m_active.snapshot) return;
    m_active.snapshot = m_robots->withPlacedRobots(std::move(snapshot));
    auto poses = std::make_shared<BodyPoses>();
    m_reader->read(*m_active.snapshot->block, *poses);
    m_active.poses = std::move(poses);
    m_ended->update();
    Q_EMIT advanced();
}

// ---- messages ----

void RunSession::addConsoleLine(int severity, const QString& text) {
    m_messages->add(m_active.end ? m_active.end->time : m_active.time(), severity, text);
}

void RunSession::reportLogs() {
    const LiveEnd& end = *m_active.end;
    if (const QString finish = m_active.finishText(); !finish.isEmpty()) addConsoleLine(TRUNDLE_INFO, finish);
    else if (!end.failure) addConsoleLine(TRUNDLE_INFO, tr("finished at t = %1 s").arg(end.time));
    QStringList files;
    for (const std::string& file : end.logFiles) files.append(QString::fromStdString(m_document.texts().shown(file)));
    if (files.empty()) return;
    addConsoleLine(TRUNDLE_INFO, tr("wrote %1").arg(files.join(QStringLiteral(", "))));
    m_logs->written(); // a controller may have opened the first log
}

/// Reports, each time the run is resumed, that it does not include the edits since it was built.
void RunSession::reportWaitingEdits() {
    if (!m_edits->needsReset()) return;
    const QString text = tr("Continues without the edits of %1: Shift+F5, then F5, runs with them").arg(m_edits->waitingText());
    addConsoleLine(TRUNDLE_INFO, text);
    Q_EMIT m_document.notice(text);
}

// ---- document changes during a run ----

void RunSession::followDocument(const ChangeSet& changes) {
    if (state() == RunState::Start) m_messages->clearProblems(); // those of a run that could not be built
    if (!m_active.built || !m_active.live || !m_document.loaded() || changes.after() != m_document.loaded()) return;
    LiveEdits edits = m_edits->follow(changes, m_source->project(), *m_active.experiment);
    for (auto& command : edits.commands) m_active.live->command(std::move(command));
    if (edits.experiment) {
        m_active.experiment = std::move(edits.experiment);
        Q_EMIT experimentChanged();
    }
    m_edits->setWaiting(std::move(edits.waiting));
}

} // namespace trundle
