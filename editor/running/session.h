#pragma once
// The run of the window: the document's experiment in a separate thread. It does not change the document, except by keepPoses(),
// which is an edit like any other.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <QObject>
#include <QTimer>

#include <trundle/geometry.h>

#include "base/diagnostic.h"
#include "editor/document/document.h"
#include "editor/running/preview_scene.h"
#include "editor/running/robot_match.h"
#include "run/live_run.h"
#include "run/live_values.h"
#include "scene/queries/poses.h"
#include "signals/block.h"

namespace trundle {

struct StartPoses;

/// Start: no world is built, the document's start poses are shown. Ended: by Duration, by a fault or a failed controller.
enum class RunState { Start, Building, Running, Paused, Ended };

class RunSession final : public QObject {
    Q_OBJECT
public:
    RunSession(Document& document, Application& application, QObject* parent = nullptr);
    /// Waits at most two seconds for a run to close its logs. A thread in module code that does not return is abandoned.
    ~RunSession() override;
    /// Returns to Start and waits likewise for all runs. False if one does not end: its thread keeps using its objects until the
    /// process exits.
    [[nodiscard]] bool endRuns();

    [[nodiscard]] RunState state() const { return m_state; }
    [[nodiscard]] bool isActive() const { return m_state != RunState::Start; } ///< a world exists or is being built
    [[nodiscard]] double time() const;                                         ///< s, simulated
    [[nodiscard]] double realTimeFactor() const;                               ///< over the last second
    [[nodiscard]] double speed() const { return m_speed; }                     ///< 1: real time; 0: as fast as possible
    [[nodiscard]] Application& application() const { return m_application; }
    [[nodiscard]] bool isOpen() const { return m_document.isOpen(); }
    /// Why run() would be refused; empty if it would not.
    [[nodiscard]] QString refusal() const;
    /// The text is valid, but has no instances that could run.
    [[nodiscard]] bool describesOnly() const;
    /// The experiment that would run: the document's; if it has no instances, a PreviewScene. Null if nothing is open.
    [[nodiscard]] std::shared_ptr<const ExperimentSpec> shown() const;
    /// The same for the newest text without errors; null if there was none.
    [[nodiscard]] std::shared_ptr<const ExperimentSpec> lastValid() const { return m_preview.lastValid(m_document); }
    /// The running experiment as built, with live changes applied; null at Start. Other edits made since are only in the
    /// document.
    [[nodiscard]] std::shared_ptr<const ExperimentSpec> experiment() const { return m_experiment; }
    /// The project it was built from, whose texts its diagnostics refer to. Null at Start.
    [[nodiscard]] std::shared_ptr<const LoadedProject> built() const { return m_built; }
    /// Current poses of the bodies of experiment(); null at Start and while it is built.
    [[nodiscard]] std::shared_ptr<const BodyPoses> poses() const { return m_poses; }
    [[nodiscard]] std::shared_ptr<const LiveSnapshot> snapshot() const { return m_snapshot; } ///< newest tick and statistics
    [[nodiscard]] std::shared_ptr<const SignalLayout> layout() const { return m_layout; }
    /// Live values of "robot0.leftMotor"; "": of the run itself. Empty for an object that is not in this run. Valid until the
    /// next call.
    [[nodiscard]] const std::vector<LiveValue>& liveValues(const std::string& path) const;
    /// The same as rich text for a tooltip; empty if there are none.
    [[nodiscard]] QString liveTip(const std::string& path) const;
    /// Enables contacts in snapshot(), also while paused.
    void setContactsEnabled(bool wanted);
    void setRadioEnabled(bool wanted);   ///< enables recording of radio frames for takeRadio()
    [[nodiscard]] LiveRadio takeRadio(); ///< of the current run; nothing at Start
    /// The run has reached its Duration: run(), step() and runFor() continue it and its logs.
    [[nodiscard]] bool canResume() const { return m_state == RunState::Ended && m_end && m_end->canContinue; }
    /// The folder of the logs of this run or the last one; empty if it has none.
    [[nodiscard]] const QString& logsAt() const { return m_logsAt; }
    [[nodiscard]] const std::optional<LiveEnd>& end() const { return m_end; } ///< how and why it ended; nothing before
    /// "finished by robot_0/brain at t = 83.5 s: reached"; empty if no controller ended the run.
    [[nodiscard]] QString finishText() const;
    /// Diagnostics of building and running, kept until Reset; their ranges are in the texts of built().
    [[nodiscard]] const std::vector<Diagnostic>& problems() const { return m_problems; }
    /// Wall-clock time (s) of the current tick, or of building, if it is unusually long; else 0.
    [[nodiscard]] double notRespondingSeconds() const;
    [[nodiscard]] QString unresponsiveController() const; ///< "robot0's Wanderer"; empty if it is not a controller
    [[nodiscard]] QString notRespondingText() const;      ///< the same as a sentence; empty if everything responds
    /// Current pose of a robot's config frame in the world, including a place() that waits for the next tick.
    [[nodiscard]] std::optional<Pose> robotPose(const std::string& robot) const;
    /// Whether the document's robot of that name is the one in the run, not a newer one with the same name.
    [[nodiscard]] bool isOfRun(const std::string& robot) const { return m_sameRobots.has(robot); }

    // --- commands to the world, stamped with their tick; on failure refused() gives the reason ---
    /// Applies a force (N, world frame) at a point (m, world frame) of "robot0/chassis" in every tick until endPush(). While
    /// paused it starts with the next tick.
    bool push(const std::string& body, const Vec3& force, const Vec3& point);
    void endPush();
    /// Moves a robot to a pose (world frame), at rest. While paused it is shown there at once.
    bool place(const std::string& robot, const Pose& pose);
    /// Drives a robot by its DifferentialDrive, m/s and rad/s. Its controller is not called until stopDriving(); after that the
    /// robot stops until the controller sends a new command.
    bool drive(const std::string& robot, double linear, double angular);
    void stopDriving();
    [[nodiscard]] std::string driven() const { return m_driven; } ///< robot, or empty
    /// Why a robot cannot be driven; empty if it can.
    [[nodiscard]] QString driveRefusal(const std::string& robot) const;

    /// All commands so far, with their ticks; none at Start.
    [[nodiscard]] std::vector<Command> commands() const { return m_run ? m_run->commands() : std::vector<Command>(); }
    /// Why the poses cannot be kept; empty if they can.
    [[nodiscard]] QString keepRefusal() const;

    // --- edits since the run was built ---
    /// Sorted dotted paths of properties and objects whose change in the document waits for a reset.
    [[nodiscard]] const std::vector<std::string>& waitingForReset() const { return m_waiting; }
    [[nodiscard]] bool needsReset() const { return !m_waiting.empty(); }
    [[nodiscard]] QString waitingText() const; ///< "robot0.Pos, Tick and 3 more"
    /// Whether a property, or an object that contains it, is among them.
    [[nodiscard]] bool waitsForReset(const std::string& propertyPath) const;

public Q_SLOTS:
    void run(); ///< starts if there is no world; restarts if edits wait or it did not end at its Duration; else resumes
    void pause();
    void step();                 ///< one tick
    void runFor(double seconds); ///< simulated s from now, as fast as possible, then pauses
    void reset();                ///< returns to Start
    void setSpeed(double factor);
    void keepPoses(); ///< sets Pos and HPR of the robots that moved, as one edit of the document

Q_SIGNALS:
    void stateChanged();
    void speedChanged();
    void refusalChanged();       ///< the document changed: refusal() may differ
    void advanced();             ///< new poses; at most about 60 times a second
    void valuesChanged();        ///< liveValues() may differ: at most 10 times a second, and once more when the run stops
    void experimentChanged();    ///< experiment() returns another object: built, changed live or ended
    void waitingChanged();       ///< needsReset() or the waiting edits changed
    void notRespondingChanged(); ///< notRespondingText() changed
    void logsAtChanged();
    void problemsChanged();
    void consoleLines(const std::vector<trundle::LiveLine>& lines, quint64 dropped);
    void ended(const trundle::Diagnostic& reason); ///< the simulation became unstable, a controller failed or building failed
    void refused(const QString& reason);

private:
    struct Notifier;

    bool begin(bool running, std::uint64_t steps = 0);
    void leave();
    void backToStart();
    void forgetProblems();
    [[nodiscard]] bool waitForRuns() const;
    void readSnapshot();
    void showSnapshot(std::shared_ptr<const LiveSnapshot> snapshot);
    void resume(RunState state);
    void takeReports(), showValues();
    void setState(RunState state);
    void followDocument();
    bool reject(const QString& reason);
    [[nodiscard]] const RobotSpec* robotNamed(const std::string& name) const;
    [[nodiscard]] StartPoses posesNow() const;
    [[nodiscard]] LogLocation logFolder() const;
    void takeOwnLogs(), dropOwnLogs(), reportWaitingEdits();
    void watch(), reportLogs();
    void setLogsAt(const QString& folder);
    void addConsoleLine(int severity, const QString& text);

    Document& m_document;
    Application& m_application;
    mutable PreviewScene m_preview; // caches its last result
    std::shared_ptr<Notifier> m_notifier;
    QTimer m_frames, m_watch, m_valuesPause; // m_watch: detects slow ticks; m_valuesPause: minimum interval of valuesChanged()
    bool m_valuesWait = false;
    QString m_notRespondingText;
    bool m_reportedNotResponding = false;
    RunState m_state = RunState::Start;
    double m_speed = 1;
    bool m_contacts = false, m_radio = false;

    std::unique_ptr<LiveRun> m_run;
    std::vector<std::unique_ptr<LiveRun>> m_leaving; // runs asked to stop whose threads have not ended yet
    std::shared_ptr<const LoadedProject> m_built;
    std::shared_ptr<const ExperimentSpec> m_experiment;
    std::shared_ptr<const SignalLayout> m_layout;
    std::unique_ptr<PoseReader> m_reader;
    std::shared_ptr<const LiveSnapshot> m_snapshot;
    std::unique_ptr<LiveObjects> m_live; // for m_layout
    std::shared_ptr<const BodyPoses> m_poses;
    std::vector<PlaceCommand> m_placed; // placed at m_placedTick while paused, not in a snapshot yet
    std::uint64_t m_placedTick = 0;
    std::optional<LiveEnd> m_end;
    QString m_logsAt;
    LogLocation m_ownLogs; // outside the project, for this experiment only
    std::vector<Diagnostic> m_problems;
    std::vector<std::string> m_waiting;
    std::string m_driven;
    RobotMatch m_sameRobots;
};

} // namespace trundle
