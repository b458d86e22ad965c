#pragma once
// The run of the window: the document's experiment in a separate thread. It does not change the document, except by
// RobotCommands::keepPoses(), which is an edit like any other.

#include <cstdint>
#include <memory>
#include <vector>

#include <QObject>
#include <QTimer>

#include "base/diagnostic.h"
#include "editor/document/document.h"
#include "editor/running/active_run.h"
#include "editor/running/ended_robots.h"
#include "editor/running/remote_access.h"
#include "editor/running/response_watch.h"
#include "editor/running/robot_commands.h"
#include "editor/running/run_edits.h"
#include "editor/running/run_logs.h"
#include "editor/running/run_messages.h"
#include "editor/running/run_source.h"
#include "editor/running/run_values.h"

namespace trundle {

/// Starts, paces and ends the run, and publishes its state. Its parts do the rest.
class RunSession final : public QObject {
    Q_OBJECT
public:
    RunSession(Document& document, Application& application, QObject* parent = nullptr);
    /// Waits at most two seconds for a run to close its logs. A thread in module code that does not return is abandoned.
    ~RunSession() override;
    /// Returns to Start and waits likewise for all runs. False if one does not end: its thread keeps using its objects until the
    /// process exits.
    [[nodiscard]] bool endRuns();

    [[nodiscard]] RunState state() const { return m_active.state; }
    [[nodiscard]] double speed() const { return m_speed; } ///< 1: real time; 0: as fast as possible
    [[nodiscard]] const RunResults& results() const { return m_active; }
    /// Contacts: in RunResults::snapshot, also while paused. Radio: frames for takeRadio().
    enum class Extra { Contacts, Radio };
    void enable(Extra what, bool wanted);
    [[nodiscard]] LiveRadio takeRadio(); ///< of the current run; nothing at Start

    [[nodiscard]] RunSource& source() const { return *m_source; }
    [[nodiscard]] RunMessages& messages() const { return *m_messages; }
    [[nodiscard]] RunLogs& logs() const { return *m_logs; }
    [[nodiscard]] RunEdits& edits() const { return *m_edits; }
    [[nodiscard]] RunValues& values() const { return *m_values; }
    [[nodiscard]] ResponseWatch& responses() const { return *m_responses; }
    [[nodiscard]] RobotCommands& robots() const { return *m_robots; }
    [[nodiscard]] RemoteAccess& remote() const { return *m_remote; }

public Q_SLOTS:
    void run(); ///< starts if there is no world; restarts if edits wait or it did not end at its Duration; else resumes
    void pause();
    void step();                 ///< one tick
    void runFor(double seconds); ///< simulated s from now, as fast as possible, then pauses
    void reset();                ///< returns to Start
    void setSpeed(double factor);

Q_SIGNALS:
    void stateChanged();
    void speedChanged();
    void advanced();                               ///< new poses; at most about 60 times a second
    void experimentChanged();                      ///< another experiment in results(): built, changed live or ended
    void ended(const trundle::Diagnostic& reason); ///< the simulation became unstable, a controller failed or building failed

private:
    struct Notifier;

    bool begin(bool running, std::uint64_t steps = 0);
    void leave();
    void backToStart();
    [[nodiscard]] bool waitForRuns() const;
    void readSnapshot();
    void showSnapshot(std::shared_ptr<const LiveSnapshot> snapshot);
    void resume(RunState state);
    void endRun();
    void setState(RunState state);
    void serveOthers();
    void followSpeed(double speed);
    void followDocument(const ChangeSet& changes);
    void reportLogs(), reportWaitingEdits(), saveModules();
    void addConsoleLine(int severity, const QString& text);
    void warn(const QString& text);

    Document& m_document;
    std::shared_ptr<Notifier> m_notifier;
    QTimer m_frames;
    double m_speed = 1;
    bool m_contacts = false, m_radio = false;

    ActiveRun m_active;
    std::vector<std::unique_ptr<LiveRun>> m_leaving; // runs asked to stop whose threads have not ended yet
    std::unique_ptr<PoseReader> m_reader;
    const std::unique_ptr<RunSource> m_source;
    const std::unique_ptr<RunMessages> m_messages;
    const std::unique_ptr<RunLogs> m_logs;
    const std::unique_ptr<RunEdits> m_edits;
    const std::unique_ptr<EndedRobots> m_ended;
    const std::unique_ptr<RunValues> m_values;
    const std::unique_ptr<ResponseWatch> m_responses;
    const std::unique_ptr<RobotCommands> m_robots;
    const std::unique_ptr<RemoteAccess> m_remote;
};

} // namespace trundle
