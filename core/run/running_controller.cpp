#include "run/running_controller.h"

#include <chrono>

namespace trundle {

Status RunningController::start(World& world, ControllerOutputs outputs, CallMonitor& calls) {
    const MonitoredCall call(calls, target, "setup");
    return backend->start(world.layout(), world.block(), std::move(outputs));
}

Status RunningController::set(const PropertyCommand& command, bool isStopped, CallMonitor& calls) {
    if (!isStopped && !backend->fault()) {
        const MonitoredCall call(calls, target, "set");
        if (Status done = backend->set(command.property, command.value); !done) return done;
    }
    liveValues.insert_or_assign(command.property, command.value);
    return {};
}

std::vector<Error> RunningController::setLiveValues(CallMonitor& calls) {
    std::vector<Error> refused;
    const MonitoredCall call(calls, target, "set");
    std::erase_if(liveValues, [&](const auto& each) {
        if (backend->fault()) return false;
        const Status done = backend->set(each.first, each.second);
        if (done || backend->fault()) return false;
        refused.push_back(done.error());
        return true;
    });
    return refused;
}

Result<std::string> RunningController::saveState(CallMonitor& calls) {
    const MonitoredCall call(calls, target, "saveState");
    return backend->saveState();
}

Status RunningController::loadState(const std::string& state, CallMonitor& calls) {
    const MonitoredCall call(calls, target, "loadState");
    return backend->loadState(state);
}

void RunningController::stop(CallMonitor& calls) {
    const MonitoredCall call(calls, target, "destructor");
    backend->stop();
}

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
