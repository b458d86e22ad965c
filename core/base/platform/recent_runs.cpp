#include "base/platform/recent_runs.h"

#include <mutex>

namespace trundle {
namespace {

constexpr std::size_t kRuns = std::tuple_size_v<decltype(recentRuns())>;

// Global, because signal handlers receive no arguments of ours.
std::array<std::atomic<const CallMonitor*>, kRuns> s_runs{};
std::atomic<std::size_t> s_count{0};
constinit thread_local const CallMonitor* t_run = nullptr;

} // namespace

RunOfThread::RunOfThread(std::shared_ptr<const CallMonitor> calls) {
    static std::mutex s_lock;
    using Owners = std::array<std::shared_ptr<const CallMonitor>, kRuns>;
    static Owners& s_owners = *new Owners; // never destroyed: a thread of a run may still end while the program does
    const std::scoped_lock guard(s_lock);
    t_run = calls.get();
    const std::size_t at = s_count % kRuns;
    s_runs[at] = calls.get();
    s_owners[at].swap(calls); // the run that it replaces ends here
    ++s_count;
}

RunOfThread::~RunOfThread() { t_run = nullptr; }

const CallMonitor* runOfThread() noexcept { return t_run; }

void setRunOfThread(const CallMonitor* run) noexcept { t_run = run; }

std::array<const CallMonitor*, kRuns> recentRuns() noexcept {
    std::array<const CallMonitor*, kRuns> runs{};
    const std::size_t count = s_count;
    for (std::size_t i = 0; i < kRuns && i < count; ++i) runs[i] = s_runs[(count - 1 - i) % kRuns];
    return runs;
}

} // namespace trundle
