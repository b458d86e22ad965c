#pragma once
// Runs one experiment: world, controllers, commands and logs, tick by tick. Owns no thread; the caller calls tick().

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/call_monitor.h"
#include "base/diagnostic.h"
#include "base/result.h"
#include "control/backend.h"
#include "run/camera_capture.h"
#include "run/command.h"
#include "run/logs/log_location.h"
#include "run/schedule.h"
#include "world/world.h"

namespace trundle {

/// Which controller a backend is made for.
struct ControllerRequest {
    std::shared_ptr<const RobotSpec> robot;
    std::size_t controller = 0; ///< its index there
    const SettingsSpec& settings;
    std::string library; ///< path of its module, for one that comes during the run; empty: it is one of the experiment
};
/// Fails with a module diagnostic.
using BackendFactory = std::function<Result<std::unique_ptr<ControllerBackend>>(const ControllerRequest& request)>;

struct RunOptions {
    LogLocation logFolder; ///< earlier log files in it are replaced; nothing is written outside it. Empty: no logs
    std::function<void(double time, const std::string& robot, int severity, const std::string& text)> console;
    ImageSourceFactory pictures;        ///< none: cameras give no images
    std::shared_ptr<CallMonitor> calls; ///< for monitoring from other threads; created by the run if null
    bool measuresControllers = false;   ///< see Runner::controllerCosts()
    bool keepsCommands = true;          ///< see Runner::commands(); else each is dropped when it has been applied
    /// Puts another world in place of the one that was built; null, with an error in the diagnostics: there is no run.
    std::function<std::unique_ptr<World>(std::unique_ptr<World> built, Diagnostics& diagnostics)> replaceWorld;
    /// Puts other radios, or names of objects, in place of those of the world, for each controller.
    std::function<void(ControllerOutputs& outputs)> replaceOutputs;
    std::shared_ptr<void> keeps;        ///< released after controllers and devices: the libraries with their code
};

/// The request of a controller that ended the run with finish().
struct RunFinish {
    std::string robot, controller, reason;
    double time = 0; ///< s, simulated, at the end of the tick of the call
};

/// A controller that a fault of its own, or a StopCommand, stopped while the run continues: it is not called any more, and its
/// commands are 0. A RestartCommand removes it.
struct StoppedController {
    std::size_t robot = 0;  ///< index in the experiment
    std::string controller; ///< its name
    double time = 0;        ///< s, simulated
    ControllerFault fault;
    bool byCommand = false; ///< a StopCommand; there was no fault
};

/// The one that the fault which a diagnostic of the run reports has stopped; nullptr: it reports something else.
[[nodiscard]] const StoppedController* stoppedBy(const Diagnostic& problem, const std::vector<StoppedController>& stopped);

/// What a controller cost since the start of the run. The wall times depend on the machine and affect nothing.
struct ControllerCost {
    std::size_t robot = 0;          ///< index in the experiment
    std::string controller;         ///< its name
    std::uint64_t calls = 0;        ///< completed updates that were measured
    double totalS = 0, worstS = 0;  ///< wall time of these, s
    double lastCall = 0;            ///< s, simulated; valid if calls > 0
    std::size_t restarts = 0;       ///< by a command, in a new process after a fault of another controller, with new code
    std::int64_t process = 0;       ///< identifier of its host process; 0: it runs inside the program, or its host has ended

    void add(double time, double seconds) {
        ++calls;
        totalS += seconds;
        worstS = seconds > worstS ? seconds : worstS;
        lastCall = time;
    }
};

class Runner {
public:
    /// Builds world and controllers. Returns nullptr, with errors in `diagnostics`, on failure.
    [[nodiscard]] static std::unique_ptr<Runner> create(std::shared_ptr<const ExperimentSpec> experiment,
                                                        const DeviceCode& devices, const BackendFactory& backends,
                                                        RunOptions options, Diagnostics& diagnostics);
    virtual ~Runner() = default;

    /// Runs one tick: controllers, World::tick, logs. A failed controller or an unstable world ends the run: see failure().
    [[nodiscard]] virtual Status tick() = 0;
    /// Adds a command for the coming tick; it is stamped and recorded.
    virtual void command(decltype(Command::what) what) = 0;
    [[nodiscard]] virtual const std::vector<Command>& commands() const = 0;
    /// Warnings of the run so far, each once, in order of occurrence.
    [[nodiscard]] virtual const std::vector<Diagnostic>& warnings() const = 0;
    /// The error that ended the run, with its source range; nullptr if there is none. Set by a failed tick() or finish().
    [[nodiscard]] virtual const Diagnostic* failure() const = 0;
    /// Controllers that are stopped now, in the order of their faults. A run that ends with any has failed in part.
    [[nodiscard]] virtual const std::vector<StoppedController>& stoppedControllers() const = 0;
    /// Those that a robot has now, with what came and without what left during the run; valid until the next tick.
    [[nodiscard]] virtual std::vector<const ControllerSpec*> controllersOf(const std::string& robot) const = 0;
    /// One entry for each controller, in the order of the robots. Calls are counted and measured only with
    /// RunOptions::measuresControllers.
    [[nodiscard]] virtual std::vector<ControllerCost> controllerCosts() const = 0;
    /// Set if a controller called finish(), in the first such tick or in setup during create(): the run is over.
    [[nodiscard]] virtual const RunFinish* finished() const = 0;
    /// Writes buffered log data to the files, so that it survives a crash of the program.
    virtual void flushLogs() = 0;
    /// Stops the controllers, flushes and closes the logs; also called by the destructor.
    virtual Status finish() = 0;

    [[nodiscard]] virtual World& world() = 0;
    [[nodiscard]] virtual CameraCapture& cameras() = 0;
    /// Paths of the written files, in order.
    [[nodiscard]] virtual std::vector<std::string> logFiles() const = 0;
};

} // namespace trundle
