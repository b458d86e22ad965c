#pragma once
// State shared between a LiveRun and its thread: requests in one direction, results in the other, under one lock that is held
// only briefly.

#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>

#include "run/live/live_guest.h"
#include "run/live/live_radio.h"
#include "run/live/live_state.h"

namespace trundle {

using LiveClock = std::chrono::steady_clock;

struct LiveRunShared {
    std::mutex lock;
    std::condition_variable wake; ///< the run thread waits here
    std::condition_variable ends; ///< others wait here for its end

    // requests
    bool stop = false, running = false, contacts = false, showAgain = false, canContinue = false;
    std::uint64_t steps = 0;
    double speed = 1;
    std::vector<decltype(Command::what)> commands;
    std::optional<PushCommand> push; ///< repeated before every tick
    std::function<void()> changed;
    std::optional<GuestMaker> guest; ///< to replace the present one by; an empty maker: by none

    // results
    LivePhase phase = LivePhase::Building;
    bool gone = false;
    bool fetched = true; ///< the snapshot was fetched
    std::shared_ptr<const SignalLayout> layout;
    std::shared_ptr<const LiveSnapshot> snapshot;
    std::deque<LiveLine> lines;
    std::uint64_t dropped = 0;
    std::vector<Diagnostic> warnings;
    std::optional<LiveEnd> end;
    std::vector<Command> stamped;
    std::optional<LiveClock::time_point> busySince;

    RadioTraceQueue radio; ///< has its own lock

    /// Written by the runner.
    std::shared_ptr<CallMonitor> calls = std::make_shared<CallMonitor>();

    std::thread thread; ///< used by the LiveRun only
};

} // namespace trundle
