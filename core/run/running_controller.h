#pragma once
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "control/backend.h"
#include "run/runner.h"
#include "run/schedule.h"

namespace trundle {

/// A controller of a run: when it is called, what that cost, and the values that were set during the run.
struct RunningController {
    std::size_t robot;                     ///< index in the experiment
    std::shared_ptr<const RobotSpec> view; ///< the robot with this controller, which may not be the experiment's any more
    std::size_t controller;                ///< index there
    std::unique_ptr<ControllerBackend> backend;
    Schedule schedule;
    const CallTarget* target; ///< for monitoring its calls
    double budget;            ///< s, for an update; 0: any
    double lastTime = 0;
    bool called = false, held = false, removed = false;
    bool due = false, slow = false; ///< in this tick; an update took longer than the budget
    ControllerCost cost;

    /// From its setup.
    [[nodiscard]] Status start(World& world, ControllerOutputs outputs, CallMonitor& calls);
    /// Sets a live value, also for each later start; of one that is stopped for these alone.
    [[nodiscard]] Status set(const PropertyCommand& command, bool isStopped, CallMonitor& calls);
    /// After a start: sets the live values again. Returns why values were refused, which are forgotten then.
    [[nodiscard]] std::vector<Error> setLiveValues(CallMonitor& calls);
    [[nodiscard]] Result<std::string> saveState(CallMonitor& calls);
    [[nodiscard]] Status loadState(const std::string& state, CallMonitor& calls);
    void stop(CallMonitor& calls);
    /// Announces an update.
    void prepare(std::uint64_t tick, double time) { backend->prepare(tick, time, sinceLast(time)); }
    /// Calls it. With `measures` all calls are measured, else only those that have a budget to keep.
    [[nodiscard]] Status update(std::uint64_t tick, double time, CallMonitor& calls, bool measures);
    /// The time of the first update that took longer than the budget, s, once; else none.
    [[nodiscard]] std::optional<double> takeSlow() { return std::exchange(newlySlow, std::nullopt); }
    [[nodiscard]] const ControllerSpec& spec() const { return view->controllers[controller]; }
    [[nodiscard]] ControllerCost costNow() const;
    [[nodiscard]] double sinceLast(double time) const { return called ? time - lastTime : 0; }

    std::optional<double> newlySlow = {};
    std::map<std::string, PropertyValue> liveValues = {}; ///< that were set during the run, by property
};

} // namespace trundle
