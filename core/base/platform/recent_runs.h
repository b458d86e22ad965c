#pragma once
// The runs of this process, for crash handlers: which calls they made, and in which thread.

#include <array>
#include <memory>

#include "base/call_monitor.h"

namespace trundle {

/// Makes a run known, as the run of the thread that creates this object.
class RunOfThread {
public:
    explicit RunOfThread(std::shared_ptr<const CallMonitor> calls);
    ~RunOfThread();
    RunOfThread(const RunOfThread&) = delete;
    RunOfThread& operator=(const RunOfThread&) = delete;
};

/// The run of the calling thread; nullptr: none. Async-signal-safe.
[[nodiscard]] const CallMonitor* runOfThread() noexcept;

/// The calling thread works for a run of another thread, which has made it known; nullptr: for none any more.
void setRunOfThread(const CallMonitor* run) noexcept;

/// The most recent runs, newest first, then nullptr: also ended ones, whose modules may have left threads. Async-signal-safe.
[[nodiscard]] std::array<const CallMonitor*, 16> recentRuns() noexcept;

} // namespace trundle
