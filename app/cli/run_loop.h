#pragma once
#include <cstdint>
#include <functional>

#include "cli/drive_statistics.h"
#include "cli/progress.h"
#include "run/runner.h"

namespace trundle {

struct LoopOutcome {
    double wallS = 0;         ///< wall-clock time since the first tick
    bool interrupted = false; ///< ended by Ctrl+C, SIGTERM or SIGHUP
};

struct LoopPlan {
    std::uint64_t ticks = 0;
    bool endless = false;                        ///< runs until stopped and ignores `ticks`
    bool realtime = false;                       ///< no faster than real time
    std::function<void()> everySecond;           ///< called every second of wall-clock time, between two ticks
    std::function<bool()> afterTick;             ///< returns false to stop
    std::function<void(const Diagnostic&)> warn; ///< called for each new warning of the runner
};

/// Ticks as planned until interrupted or until a tick fails; runner.failure() then gives the reason.
[[nodiscard]] LoopOutcome runTicks(Runner& runner, const LoopPlan& plan, Progress& progress, DriveStatistics* meter);

} // namespace trundle
