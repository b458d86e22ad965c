#include "run/running_controller.h"

#include <chrono>

namespace trundle {

Status RunningController::update(std::uint64_t tick, double time, CallMonitor& calls, bool measures) {
    using Clock = std::chrono::steady_clock;
    const double since = sinceLast(time);
    lastTime = time;
    called = true;
    const MonitoredCall call(calls, target, "update");
    const bool isLimited = budget > 0 && !slow;
    if (!isLimited && !measures) return backend->tick(tick, time, since);
    const Clock::time_point begin = Clock::now();
    Status done = backend->tick(tick, time, since);
    const double seconds = backend->updateS().value_or(std::chrono::duration<double>(Clock::now() - begin).count());
    if (done) cost.add(time, seconds);
    if (isLimited && seconds > budget) {
        slow = true;
        newlySlow = seconds;
    }
    return done;
}

ControllerCost RunningController::costNow() const {
    ControllerCost now = cost;
    now.robot = robot;
    now.controller = spec().name;
    now.process = backend->processId();
    return now;
}

} // namespace trundle
