#pragma once
// The run that the window shows: the document's experiment in a thread of its own. The document is never written by it, but for
// keepPoses(), which is an edit like any other.

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
#include "editor/running/same_robots.h"
#include "run/live_run.h"
#include "run/live_values.h"
#include "scene/poses.h"
#include "signals/block.h"

namespace trundle {

struct KeptPoses;

/// Start: no world is built, the document's start poses are shown. Ended: by Duration, by a fault or a failed controller.
enum class RunState { Start, Building, Running, Paused, Ended };

class RunSession final : public QObject {
    Q_OBJECT
public:
    RunSession(Document& document, Parts& parts, QObject* parent = nullptr);
    /// Waits at most two seconds for a run to close its logs. Code of a module that does not come back is left behind.
    ~RunSession() override;
    /// Goes back to Start and waits so for all runs. False where one does not come to its end: its thread uses what it has until the
    /// program is gone.
    [[nodiscard]] bool endRuns();

    [[nodiscard]] RunState state() const { return m_state; }
    [[nodiscard]] bool isActive() const { return m_state != RunState::Start; } ///< there is a world, or soon will be
    [[nodiscard]] double time() const;                                         ///< s, simulated
    [[nodiscard]] double realTimeFactor() const;                               ///< over the last second
    [[nodiscard]] double speed() const { return m_speed; }                     ///< 1: real time; 0: as fast as possible
    [[nodiscard]] Parts& parts() const { return m_parts; }
    [[nodiscard]] bool isOpen() const { return m_document.isOpen(); }
    /// Why run() would be refused; empty where it would not.
    [[nodiscard]] QString refusal() const;
    /// The text is whole, but places nothing that could run.
    [[nodiscard]] bool describesOnly() const;
    /// What would run: the document's experiment; where that places nothing, a PreviewScene. Null where nothing is open.
    [[nodiscard]] std::shared_ptr<const ExperimentSpec> shown() const;
    /// The same of the newest text that had no errors; null before there was one.
    [[nodiscard]] std::shared_ptr<const ExperimentSpec> lastGood() const { return m_preview.lastGood(m_document); }
    /// What runs, as built but with what was changed live; null at Start. Other edits made since are in the document only.
    [[nodiscard]] std::shared_ptr<const ExperimentSpec> experiment() const { return m_experiment; }
    /// The texts it was built from: where its diagnostics point. Null at Start.
    [[nodiscard]] std::shared_ptr<const Loaded> built() const { return m_built; }
    /// Where the bodies of experiment() stand now; null at Start and while it is built.
    [[nodiscard]] std::shared_ptr<const BodyPoses> poses() const { return m_poses; }
    [[nodiscard]] std::shared_ptr<const LiveSnapshot> snapshot() const { return m_snapshot; } ///< the newest tick with its figures
    [[nodiscard]] std::shared_ptr<const SignalLayout> layout() const { return m_layout; }
    /// What "robot0.leftMotor" measures and does now; "": the run itself. Empty for what is not in this run. Good until the next call.
    [[nodiscard]] const std::vector<LiveValue>& liveValues(const std::string& path) const;
    /// The same as rich text for a tooltip; empty where there are none.
    [[nodiscard]] QString liveTip(const std::string& path) const;
    /// Contacts come with snapshot() from now on, also while paused.
    void wantContacts(bool wanted);
    void wantRadio(bool wanted); ///< what flies between the radios is kept for takeRadio() from now on
    [[nodiscard]] LiveRadio takeRadio(); ///< of the present run; nothing at Start
    /// It stands at its Duration: run(), step() and runFor() go on past it, and so do its logs.
    [[nodiscard]] bool canGoOn() const { return m_state == RunState::Ended && m_end && m_end->goesOn; }
    /// The folder that this run or the last one writes its logs into; empty where it has none.
    [[nodiscard]] const QString& logsAt() const { return m_logsAt; }
    [[nodiscard]] const std::optional<LiveEnd>& end() const { return m_end; } ///< how and why it ended; nothing before
    /// "finished by robot_0/brain at t = 83.5 s: reached"; empty where no controller ended the run.
    [[nodiscard]] QString finishText() const;
    /// What building and running had to say, until Reset, in built()'s texts.
    [[nodiscard]] const std::vector<Diagnostic>& problems() const { return m_problems; }
    /// Wall s that one tick (or building) has taken so far, where that is remarkably long; else 0.
    [[nodiscard]] double heldUpS() const;
    [[nodiscard]] QString heldUpBy() const;   ///< "robot0's Wanderer"; empty where it is no controller
    [[nodiscard]] QString heldUpText() const; ///< the same in a sentence; empty while nothing is held up
    /// Where a robot's config frame stands now (with a placement that waits for the next tick).
    [[nodiscard]] std::optional<Pose> robotPose(const std::string& robot) const;
    /// The document's robot of that name is the one that runs, not another that took its name since.
    [[nodiscard]] bool isOfRun(const std::string& robot) const { return m_sameRobots.has(robot); }

    // --- the world, by stamped commands; refused() says why where they cannot be done ---
    /// Force (N, world) at a point (m, world) on "robot0/chassis" in every tick until endPush(). While paused it works from
    /// the next tick on.
    bool push(const std::string& body, const Vec3& force, const Vec3& point);
    void endPush();
    /// Puts a robot somewhere, at rest. While paused it is shown there at once.
    bool place(const std::string& robot, const Pose& pose);
    /// Drives a robot by its DifferentialDrive, m/s and rad/s; its controller has no turn until stopDriving(), after which the
    /// robot stands until the controller commands something new.
    bool drive(const std::string& robot, double linear, double angular);
    void stopDriving();
    [[nodiscard]] std::string driven() const { return m_driven; } ///< robot, or empty
    /// Why a robot cannot be driven; empty where it can.
    [[nodiscard]] QString driveRefusal(const std::string& robot) const;

    /// All that was done so, as it was stamped; none at Start.
    [[nodiscard]] std::vector<Command> commands() const { return m_run ? m_run->commands() : std::vector<Command>(); }
    /// Why the poses cannot be kept; empty where they can.
    [[nodiscard]] QString keepRefusal() const;

    // --- edits since it was built ---
    /// Dotted paths of properties and objects whose change in the document waits for a reset, sorted.
    [[nodiscard]] const std::vector<std::string>& waitingForReset() const { return m_waiting; }
    [[nodiscard]] bool needsReset() const { return !m_waiting.empty(); }
    [[nodiscard]] QString waitingText() const; ///< "robot0.Pos, Tick and 3 more"
    /// Whether a property (or an object it stands in) is among them.
    [[nodiscard]] bool waitsForReset(const std::string& propertyPath) const;

public Q_SLOTS:
    void run(); ///< begins where there is no world, and again after an end where edits wait or that was not its Duration; else goes on
    void pause();
    void step();                 ///< one tick
    void runFor(double seconds); ///< simulated s from now as fast as possible, then pauses
    void reset();                ///< back to Start
    void setSpeed(double factor);
    void keepPoses(); ///< Pos and HPR of the robots that moved, as one edit of the document

Q_SIGNALS:
    void stateChanged();
    void speedChanged();
    void refusalChanged();    ///< the document changed: whether and why run() would be refused
    void advanced();          ///< new poses; at most about 60 times a second
    void valuesChanged();     ///< liveValues() may be others: 10 times a second at most, and once more when the run stands
    void experimentChanged(); ///< experiment() is another one: built, changed live or gone
    void waitingChanged();    ///< needsReset() or what waits
    void heldUpChanged();     ///< heldUpText() is another one
    void logsAtChanged();
    void problemsChanged();
    void consoleLines(const std::vector<trundle::LiveLine>& lines, quint64 dropped);
    void ended(const trundle::Diagnostic& reason); ///< blew up, a controller failed or nothing could be built
    void refused(const QString& reason);

private:
    struct Doorbell;

    bool begin(bool running, std::uint64_t steps = 0);
    void leave();
    void backToStart();
    void forgetProblems();
    [[nodiscard]] bool waitForRuns() const;
    void look();
    void showSnapshot(std::shared_ptr<const LiveSnapshot> snapshot);
    void showValues();
    void goOn(RunState state);
    void takeReports();
    void setState(RunState state);
    void followDocument();
    bool refuse(const QString& reason);
    [[nodiscard]] const RobotSpec* robotNamed(const std::string& name) const;
    [[nodiscard]] KeptPoses posesNow() const;
    [[nodiscard]] LogLocation logFolder() const;
    void takeOwnLogs(), dropOwnLogs(), sayWithoutEdits();
    void watch();
    void tellLogs();
    void setLogsAt(const QString& folder);
    void tell(int severity, const QString& text);

    Document& m_document;
    Parts& m_parts;
    mutable PreviewScene m_preview; // keeps what it read last
    std::shared_ptr<Doorbell> m_doorbell;
    QTimer m_frames, m_watch, m_valuesPause; // m_watch: whether a tick comes to its end; m_valuesPause: after valuesChanged()
    bool m_valuesWait = false;
    QString m_saidHeldUp;
    bool m_toldHeldUp = false;
    RunState m_state = RunState::Start;
    double m_speed = 1;
    bool m_contacts = false, m_radio = false;

    std::unique_ptr<LiveRun> m_run;
    std::vector<std::unique_ptr<LiveRun>> m_leaving; // told to stop
    std::shared_ptr<const Loaded> m_built;
    std::shared_ptr<const ExperimentSpec> m_experiment;
    std::shared_ptr<const SignalLayout> m_layout;
    std::unique_ptr<PoseReader> m_reader;
    std::shared_ptr<const LiveSnapshot> m_snapshot;
    std::unique_ptr<LiveObjects> m_live; // of m_layout
    std::shared_ptr<const BodyPoses> m_poses;
    std::vector<PlaceCommand> m_placed; // at m_placedTick, not yet in a snapshot
    std::uint64_t m_placedTick = 0;
    std::optional<LiveEnd> m_end;
    QString m_logsAt;
    LogLocation m_ownLogs; // outside the project, of this experiment alone
    std::vector<Diagnostic> m_problems;
    std::vector<std::string> m_waiting;
    std::string m_driven;
    SameRobots m_sameRobots;
};

} // namespace trundle
