#pragma once
// Runs one experiment in a thread of its own: requests and commands in, the latest state and console lines out. No call here
// waits for the thread, except waitUntilGone().

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostic.h"
#include "run/live_radio.h"
#include "run/runner.h"
#include "signals/block.h"
#include "signals/layout.h"

namespace trundle {

/// Running: also while single ticks are executed. Paused: the snapshot shows the current tick. Ended: by Duration (see
/// Options::canContinue), a controller's finish(), a fault, a failed controller, or a failed build; the logs are closed by then.
enum class LivePhase { Building, Paused, Running, Ended };

/// A copy of a contact, valid without the world.
struct LiveContact {
    std::string first, second; ///< geoms "robot0/chassis/bumper", "arena/north"
    Vec3 position = Vec3::Zero(), normal = Vec3::UnitZ();
    double depth = 0, force = 0; ///< m, N
};

/// The state after one tick. Immutable; may be kept as long as needed.
struct LiveSnapshot {
    std::shared_ptr<const SignalBlock> block;
    std::shared_ptr<const std::vector<LiveContact>> contacts; ///< null unless enabled
    std::uint64_t tick = 0, quickTicks = 0;
    double time = 0;           ///< s, simulated
    double realTimeFactor = 0; ///< over about the last second; 0 while paused
    double stepMs = 0;         ///< mean wall time per tick since the previous snapshot
    std::size_t contactCount = 0;
    std::optional<std::uint64_t> hash; ///< World::stateHash(); set only while paused or ended
};

struct LiveLine {
    double time = 0;
    std::string who; ///< "robot0", "robot0/leftMotor"; "" for the run itself
    int severity = 0;
    std::string text;
};

/// Console lines since the last call. If too many are waiting, the oldest are dropped and counted.
struct LiveLines {
    std::vector<LiveLine> lines;
    std::uint64_t dropped = 0;
};

/// A consistent view of the run at one moment.
struct LiveView {
    LivePhase phase = LivePhase::Building;
    std::shared_ptr<const SignalLayout> layout;   ///< null until built
    std::shared_ptr<const LiveSnapshot> snapshot; ///< null until built
};

struct LiveEnd {
    std::optional<Diagnostic> failure; ///< none: ended by Duration or by a controller
    std::optional<RunFinish> finish;   ///< set if a controller ended the run
    std::string body;                  ///< the body with the fault: "robot0/chassis"; empty: none
    double time = 0;                   ///< s, simulated
    std::vector<Diagnostic> problems;  ///< diagnostics of the build
    std::vector<std::string> logFiles;
    bool canContinue = false; ///< ended by Duration with logs flushed but open: run() and step() continue without limit
};

/// Creates the runner; called once, on the run's thread. Everything that it references must outlive the run.
using RunnerMaker = std::function<std::unique_ptr<Runner>(RunOptions, Diagnostics&)>;

class LiveRun {
public:
    struct Options {
        LogLocation logFolder;
        double speed = 1;                     ///< see setSpeed()
        bool startsRunning = false;           ///< starts when built; otherwise paused at tick 0
        std::uint64_t steps = 0;              ///< ticks to execute at the start, unless startsRunning
        bool canContinue = false;             ///< at Duration, keeps its logs open so that it can continue
        bool contacts = false, radio = false; ///< initial values of setContactsEnabled(), setRadioEnabled()
        /// Called on the run's thread when phase() has changed or a step is done. Must not block.
        std::function<void()> changed;
        /// An earlier run with the same logs that was asked to stop: building waits for its end. If it does not end within
        /// `timeout`, this run writes no logs.
        const LiveRun* after = nullptr;
        std::chrono::milliseconds timeout{5000}; ///< limit for that wait
    };

    LiveRun(RunnerMaker maker, Options options);
    /// Requests a stop and returns without waiting. The thread ends after the current tick; if a tick never returns (an endless
    /// loop in a controller), the thread and its resources are leaked.
    ~LiveRun();
    LiveRun(const LiveRun&) = delete;
    LiveRun& operator=(const LiveRun&) = delete;

    void run();
    void pause();
    void step(std::uint64_t ticks = 1); ///< executes ticks, then pauses
    void stop();                        ///< permanently, after the current tick
    void setSpeed(double factor);       ///< simulated s per s; 0: as fast as possible
    void setContactsEnabled(bool wanted); ///< for future snapshots; a paused run makes a new snapshot
    void setRadioEnabled(bool wanted);    ///< effective from the next tick
    /// Applies to the coming tick. Of several commands for one tick that push the same body, place the same robot or write the
    /// same signal, only the last counts.
    void command(decltype(Command::what) what);
    /// Repeats a push before every tick until it is replaced or removed; each repetition is a command of its own.
    void keepPushing(std::optional<PushCommand> push);

    [[nodiscard]] LiveView view() const;
    [[nodiscard]] LivePhase phase() const;
    [[nodiscard]] bool gone() const; ///< its thread has ended
    /// Waits for the end of the thread for at most this time.
    bool waitUntilGone(std::chrono::milliseconds atMost);
    [[nodiscard]] double speed() const;
    /// Null until built.
    [[nodiscard]] std::shared_ptr<const SignalLayout> layout() const;
    [[nodiscard]] std::shared_ptr<const LiveSnapshot> snapshot() const;
    [[nodiscard]] LiveLines takeLines();
    [[nodiscard]] LiveRadio takeRadio();
    [[nodiscard]] std::vector<Diagnostic> takeWarnings(); ///< including those of the build
    [[nodiscard]] std::optional<LiveEnd> end() const;
    /// All commands with their ticks.
    [[nodiscard]] std::vector<Command> commands() const;
    /// Wall time (s) of the tick or build in progress; 0 while the thread waits.
    [[nodiscard]] double busyS() const;
    /// Index of the robot whose controller is being called.
    [[nodiscard]] std::optional<std::size_t> turn() const;

private:
    friend class LiveThread;
    struct Shared;
    std::shared_ptr<Shared> m_shared;
};

} // namespace trundle
