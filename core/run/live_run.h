#pragma once
// One experiment in a thread of its own: wishes and commands in, newest state and console lines out. No call here waits for
// the thread.

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

/// Running also while single ticks are under way; with Paused comes the snapshot of the tick it stands at.
/// Ended: by Duration (see Options::goesOn), by a controller's finish(), by a fault, by a failed controller, or because nothing could be built; logs are closed by then.
enum class LivePhase { Building, Paused, Running, Ended };

/// A contact that outlives the world.
struct LiveContact {
    std::string first, second; ///< geoms "robot0/chassis/bumper", "arena/north"
    Vec3 position = Vec3::Zero(), normal = Vec3::UnitZ();
    double depth = 0, force = 0; ///< m, N
};

/// The world after one tick. Immutable: keep it as long as needed.
struct LiveSnapshot {
    std::shared_ptr<const SignalBlock> block;
    std::shared_ptr<const std::vector<LiveContact>> contacts; ///< null unless they were wanted
    std::uint64_t tick = 0, quickTicks = 0;
    double time = 0;           ///< s, simulated
    double realTimeFactor = 0; ///< over about the last second; 0 while it stands
    double stepMs = 0;         ///< wall time of a tick, mean since the snapshot before
    std::size_t contactCount = 0;
    std::optional<std::uint64_t> hash; ///< World::stateHash(), whenever the run stands
};

struct LiveLine {
    double time = 0;
    std::string who; ///< "robot0", "robot0/leftMotor", "" for the run itself
    int severity = 0;
    std::string text;
};

/// Console lines since the last look. What nobody fetched in time is counted and gone, oldest first.
struct LiveLines {
    std::vector<LiveLine> lines;
    std::uint64_t dropped = 0;
};

/// All that belongs together at one moment.
struct LiveView {
    LivePhase phase = LivePhase::Building;
    std::shared_ptr<const SignalLayout> layout;   ///< null until built
    std::shared_ptr<const LiveSnapshot> snapshot; ///< null until built
};

struct LiveEnd {
    std::optional<Diagnostic> failure; ///< none: it came to its Duration, or a controller finished it
    std::optional<RunFinish> finish;   ///< by a controller
    std::string body;                  ///< that blew up: "robot0/chassis"; empty where it is none
    double time = 0;                   ///< s, simulated
    std::vector<Diagnostic> problems;  ///< of building
    std::vector<std::string> logFiles;
    bool goesOn = false; ///< it stands at its Duration, its logs written so far but open: run() and step() go on without limit
};

/// Makes the runner; called once, on the run's thread. What it holds on to must live as long as the run.
using RunnerMaker = std::function<std::unique_ptr<Runner>(RunOptions, Diagnostics&)>;

class LiveRun {
public:
    struct Options {
        LogLocation logFolder;
        double speed = 1;                     ///< see setSpeed()
        bool startsRunning = false;           ///< runs as soon as it is built, else it is paused at tick 0
        std::uint64_t steps = 0;              ///< ticks to take first of all, unless it runs anyway
        bool goesOn = false; ///< at its Duration it does not close its logs, and can go on; else it is over
        bool contacts = false, radio = false; ///< as by wantContacts(), wantRadio()
        /// Called on the run's thread when phase() changed or a step was done. Must not block.
        std::function<void()> changed;
        /// A run of the same logs that was told to stop: building waits for its end. One that does not end keeps its logs, and
        /// this one writes none.
        const LiveRun* after = nullptr;
        std::chrono::milliseconds patience{5000}; ///< how long it waits for that
    };

    LiveRun(RunnerMaker maker, Options options);
    /// Tells the thread to stop and does not wait. It ends after the tick it is in; one that never comes back (a controller in an
    /// endless loop) is left behind with all it holds.
    ~LiveRun();
    LiveRun(const LiveRun&) = delete;
    LiveRun& operator=(const LiveRun&) = delete;

    void run();
    void pause();
    void step(std::uint64_t ticks = 1); ///< then pauses
    void stop();                        ///< for good, after the tick it is in
    void setSpeed(double factor);       ///< simulated s per s; 0: as fast as possible
    void wantContacts(bool wanted);     ///< in snapshots from now on; a run that stands makes a new one
    void wantRadio(bool wanted);        ///< what flies is kept from the next tick on
    /// For the coming tick. Of several before it that push one body, place one robot or write one signal, the last counts.
    void command(decltype(Command::what) what);
    /// Pushes before every tick from now on, until it is replaced or ended; each is a command of its own.
    void keepPushing(std::optional<PushCommand> push);

    [[nodiscard]] LiveView view() const;
    [[nodiscard]] LivePhase phase() const;
    [[nodiscard]] bool gone() const; ///< its thread is through
    /// Waits for that at most so long.
    bool waitUntilGone(std::chrono::milliseconds atMost);
    [[nodiscard]] double speed() const;
    /// Null until built.
    [[nodiscard]] std::shared_ptr<const SignalLayout> layout() const;
    [[nodiscard]] std::shared_ptr<const LiveSnapshot> snapshot() const;
    [[nodiscard]] LiveLines takeLines();
    [[nodiscard]] LiveRadio takeRadio();
    [[nodiscard]] std::vector<Diagnostic> takeWarnings(); ///< also those of building
    [[nodiscard]] std::optional<LiveEnd> end() const;
    /// As stamped by the runner.
    [[nodiscard]] std::vector<Command> commands() const;
    /// Wall s that the thread has been busy with one tick (or with building); 0 while it waits.
    [[nodiscard]] double busyS() const;
    /// Robot whose controller has its turn now, by its place in the experiment.
    [[nodiscard]] std::optional<std::size_t> turn() const;

private:
    friend class LiveThread;
    struct Shared;
    std::shared_ptr<Shared> m_shared;
};

} // namespace trundle
