#include "cli/run_loop.h"

#include <chrono>
#include <cmath>
#include <ctime>

#include "cli/run_guard.h"

namespace trundle {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds kSecond(1);

double secondsSince(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// Sleeps until `seconds` after the start, or until a signal arrives.
void sleepUntil(Clock::time_point start, double seconds) {
    while (!interrupted()) {
        const double left = seconds - secondsSince(start);
        if (left <= 0) return;
        const double part = std::min(left, 0.5);
        timespec pause{0, static_cast<long>(part * 1e9)};
        if (part >= 1) return;
        nanosleep(&pause, nullptr);
    }
}

} // namespace

LoopOutcome runTicks(Runner& runner, const LoopPlan& plan, Progress& progress, DriveStatistics* meter) {
    LoopOutcome outcome;
    std::size_t warned = 0;
    const Clock::time_point start = Clock::now();
    Clock::time_point next = start + kSecond;
    const double tick = runner.world().experiment().settings.tick;
    for (std::uint64_t done = 0; !runner.finished() && (plan.endless || done < plan.ticks); ++done) {
        if (isForkedCopy()) endForkedCopy();
        if (interrupted()) {
            outcome.interrupted = true;
            break;
        }
        const bool good = runner.tick().ok();
        for (; warned < runner.warnings().size(); ++warned) plan.warn(runner.warnings()[warned]);
        if (!good) break;
        if (plan.afterTick && !plan.afterTick()) break;
        if (meter) meter->afterTick(runner.world());
        progress.update(done + 1);
        if (plan.everySecond && Clock::now() >= next) {
            plan.everySecond();
            next = Clock::now() + kSecond;
        }
        if (plan.realtime) sleepUntil(start, static_cast<double>(done + 1) * tick);
    }
    if (isForkedCopy()) endForkedCopy();
    outcome.wallS = secondsSince(start);
    return outcome;
}

} // namespace trundle
