#pragma once
// Runs one experiment in a thread of its own: requests and commands in, the latest state and console lines out. No call here
// waits for the thread, except waitUntilGone().

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "run/live/live_guest.h"
#include "run/live/live_radio.h"
#include "run/live/live_state.h"

namespace trundle {

struct LiveRunShared;

class LiveRun {
public:
    struct Options {
        LogLocation logFolder;
        double speed = 1;                     ///< see setSpeed()
        bool startsRunning = false;           ///< starts when built; otherwise paused at tick 0
        std::uint64_t steps = 0;              ///< ticks to execute at the start, unless startsRunning
        bool canContinue = false;             ///< at Duration, keeps its logs open so that it can continue
        GuestMaker guest;                     ///< see setGuest()
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
    void step(std::uint64_t ticks = 1);   ///< executes ticks, then pauses
    void stop();                          ///< permanently, after the current tick
    void setSpeed(double factor);         ///< simulated s per s; 0: as fast as possible
    void setContactsEnabled(bool wanted); ///< for future snapshots; a paused run makes a new snapshot
    void setRadioEnabled(bool wanted);    ///< effective from the next tick
    /// Lets another guest take part in place of the present one; an empty maker: none.
    void setGuest(GuestMaker maker);
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
    /// The controller that is being called, valid as long as this object; nullptr: none.
    [[nodiscard]] const CallTarget* controllerInCall() const;

private:
    std::shared_ptr<LiveRunShared> m_shared;
};

} // namespace trundle
