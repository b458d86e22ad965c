#pragma once
#include <cstdint>

#include "cli/drive_meter.h"
#include "cli/progress.h"
#include "run/runner.h"

namespace trundle {

struct LoopOutcome {
    double wallS = 0;         ///< from the first tick on
    bool interrupted = false; ///< ended by Ctrl+C
};

/// Ticks until `ticks` are done (0 with `endless`: until stopped), Ctrl+C, or a tick fails: then runner.failure() says why.
[[nodiscard]] LoopOutcome runTicks(Runner& runner, std::uint64_t ticks, bool endless, bool realtime, Progress& progress, DriveMeter* meter);

} // namespace trundle
