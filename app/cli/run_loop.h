#pragma once
#include <cstdint>
#include <functional>

#include "cli/drive_meter.h"
#include "cli/progress.h"
#include "run/runner.h"

namespace trundle {

struct LoopOutcome {
    double wallS = 0;         ///< from the first tick on
    bool interrupted = false; ///< ended by Ctrl+C, SIGTERM or SIGHUP
};

struct LoopPlan {
    std::uint64_t ticks = 0;
    bool endless = false;                        ///< until stopped, whatever `ticks` is
    bool realtime = false;                       ///< no faster than that
    std::function<void()> everySecond;           ///< of the wall clock, between two ticks
    std::function<bool()> afterTick;             ///< false: no more ticks
    std::function<void(const Diagnostic&)> warn; ///< hears each warning of the runner when it comes
};

/// Ticks as planned, until Ctrl+C, or until a tick fails: then runner.failure() says why.
[[nodiscard]] LoopOutcome runTicks(Runner& runner, const LoopPlan& plan, Progress& progress, DriveMeter* meter);

} // namespace trundle
