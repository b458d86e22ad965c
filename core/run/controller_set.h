#pragma once
// The controllers of a run: their start, updates, faults, restarts and new code.

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "run/apart_updates.h"
#include "run/command.h"
#include "run/command_claims.h"
#include "run/running_controller.h"

namespace trundle {

class ControllerSet {
public:
    /// What they need of the run, which outlives them.
    struct Context {
        World& world;
        CallMonitor& calls;
        std::vector<Diagnostic>& warnings;
        std::function<ControllerOutputs(const RobotSpec& robot, const ControllerSpec& controller)> outputsFor;
        std::function<void(const std::string& robot, int severity, const std::string& text)> say; ///< a message of the run itself
        bool measures = false; ///< all calls, not only those that have a budget to keep
    };
    explicit ControllerSet(Context context) : m_context(std::move(context)) {}

    /// Those of all robots. Errors go to `diagnostics`.
    void start(const BackendFactory& backends, Diagnostics& diagnostics);
    /// Calls all that are due. Returns an error that ends the run, with the place of its controller.
    [[nodiscard]] std::optional<std::pair<Error, SourceRange>> think();
    /// At the end of the run.
    void stop();

    Status apply(const HoldCommand& command);
    Status apply(const RestartCommand& command);
    Status apply(const ReloadCommand& command);
    Status apply(const StopCommand& command);
    Status apply(const SwapCommand& command);
    [[nodiscard]] std::optional<Status> set(const PropertyCommand& command);

    [[nodiscard]] const std::vector<StoppedController>& stopped() const { return m_stopped; }
    /// Those that a robot has now, in the order of their calls; valid until the next command.
    [[nodiscard]] std::vector<const ControllerSpec*> specsOf(const std::string& robot) const;
    [[nodiscard]] std::vector<ControllerCost> costs() const;

private:
    [[nodiscard]] const ExperimentSpec& experiment() const { return m_context.world.experiment(); }
    /// Makes a controller's backend in the place of `old`; null: a place of its own. Without starting it.
    Status add(std::size_t robot, std::shared_ptr<const RobotSpec> view, std::size_t controller, const std::string& library,
               RunningController* old = nullptr);
    void remove(RunningController& controller);
    void forgetStop(const RunningController& controller);
    /// Those of a robot; with a name, that one.
    [[nodiscard]] std::vector<RunningController*> controllersOf(const std::string& robot, const std::string& name = {});
    [[nodiscard]] RunningController* controllerOf(const std::string& robot, const std::string& name);
    [[nodiscard]] ControllerOutputs outputsOf(std::size_t controller);
    [[nodiscard]] std::size_t indexOf(const RunningController& controller) const {
        return static_cast<std::size_t>(&controller - m_controllers.data());
    }
    Status claim(std::size_t controller, const std::string& command);
    void setItsCommandsToZero(const RunningController& controller);
    [[nodiscard]] bool isStopped(const RunningController& controller) const;
    void prepareUpdates(std::uint64_t tick, double time);
    Status update(RunningController& controller, std::uint64_t tick, double time);
    void stopFaulty();
    void reportFault(const RunningController& controller);
    void goOnInNewProcess(RunningController& controller);
    bool startAgain(RunningController& controller);
    [[nodiscard]] std::string stateOf(RunningController& controller);
    bool startFrom(RunningController& controller, const std::string& state);

    Context m_context;
    std::vector<RunningController> m_controllers;
    ApartUpdates m_apart;
    std::vector<StoppedController> m_stopped;
    std::map<std::string, std::set<Holder>> m_holders; ///< by robot
    CommandClaims m_claims;
    BackendFactory m_backends;
    std::uint64_t m_requests = 0; ///< to load new code
    bool m_ending = false;
};

} // namespace trundle
