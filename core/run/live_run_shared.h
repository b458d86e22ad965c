#pragma once
// What the two sides of a LiveRun share: wishes go one way, results the other, under one lock that nobody holds for long.

#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>

#include "run/live_run.h"

namespace trundle {

using LiveClock = std::chrono::steady_clock;

struct LiveRun::Shared {
    std::mutex lock;
    std::condition_variable wishes; ///< the thread waits here
    std::condition_variable ends;   ///< whoever waits for its end

    // in
    bool stop = false, running = false, contacts = false, showAgain = false, goesOn = false;
    std::uint64_t steps = 0;
    double speed = 1;
    std::vector<decltype(Command::what)> commands;
    std::optional<PushCommand> push; ///< before every tick
    std::function<void()> changed;

    // out
    LivePhase phase = LivePhase::Building;
    bool gone = false;
    bool fetched = true; ///< somebody took the snapshot
    std::shared_ptr<const SignalLayout> layout;
    std::shared_ptr<const LiveSnapshot> snapshot;
    std::deque<LiveLine> lines;
    std::uint64_t dropped = 0;
    std::vector<Diagnostic> warnings;
    std::optional<LiveEnd> end;
    std::vector<Command> stamped;
    std::optional<LiveClock::time_point> busySince;

    RadioTap radio; ///< has a lock of its own

    /// Written by the runner.
    std::shared_ptr<CallMonitor> calls = std::make_shared<CallMonitor>();

    std::thread thread; ///< touched by the owner only
};

} // namespace trundle
