#pragma once
// Runs one experiment: world, controllers, commands, logs, in tick order. Owns no thread: the caller's loop is the clock.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/call_monitor.h"
#include "base/diagnostic.h"
#include "base/result.h"
#include "control/backend.h"
#include "run/camera_desk.h"
#include "run/command.h"
#include "run/log_location.h"
#include "world/world.h"

namespace trundle {

/// Makes the backend of a robot's controller. Fails with a module diagnostic.
using BackendFactory =
    std::function<Result<std::unique_ptr<ControllerBackend>>(const RobotSpec& robot, const SettingsSpec& settings)>;

struct RunOptions {
    LogLocation logFolder; ///< this run's own files in it are replaced; nothing is written outside it. Empty: no logs
    std::function<void(double time, const std::string& robot, int severity, const std::string& text)> console;
    FrameSourceMaker pictures; ///< none: cameras take no pictures
    std::shared_ptr<CallMonitor> calls; ///< for whoever watches from elsewhere; the run makes one where there is none
    std::shared_ptr<void> keeps; ///< let go when controllers and devices are gone: the libraries that their code is in
};

/// What a controller that ended the run by finish() gave.
struct RunFinish {
    std::string robot, controller, reason;
    double time = 0; ///< s, simulated, at the end of the tick in which it was called
};

class Runner {
public:
    /// Builds world and controllers. Problems go to `diagnostics`; with an error there is no runner.
    [[nodiscard]] static std::unique_ptr<Runner> create(std::shared_ptr<const ExperimentSpec> experiment,
                                                        const DeviceCode& devices, const BackendFactory& backends,
                                                        RunOptions options, Diagnostics& diagnostics);
    virtual ~Runner() = default;

    /// think, then World::tick, then logs. A failed controller or a blown-up world ends the run: see error().
    [[nodiscard]] virtual Status tick() = 0;
    /// Enters a command for the coming tick; it is stamped and kept.
    virtual void command(decltype(Command::what) what) = 0;
    [[nodiscard]] virtual const std::vector<Command>& commands() const = 0;
    /// What a person should know of a run that goes on, each once, in the order it came up.
    [[nodiscard]] virtual const std::vector<Diagnostic>& warnings() const = 0;
    /// What ended the run early, with its place; nullptr while all is well. Set by a tick() or finish() that failed.
    [[nodiscard]] virtual const Diagnostic* failure() const = 0;
    /// Set by the first tick in which a controller called finish(), or by create() where one did so in setup: the run is over.
    [[nodiscard]] virtual const RunFinish* finished() const = 0;
    /// Gives what the logs hold to the system: it is kept then, whatever becomes of this program.
    virtual void flushLogs() = 0;
    /// Stops the controllers, flushes and closes logs; also done by the destructor.
    virtual Status finish() = 0;

    [[nodiscard]] virtual World& world() = 0;
    [[nodiscard]] virtual CameraDesk& cameras() = 0;
    /// Files written, in order.
    [[nodiscard]] virtual std::vector<std::string> logFiles() const = 0;
};

/// ceil(duration / tick - 1e-9)
[[nodiscard]] std::uint64_t ticksFor(double duration, double tick);

} // namespace trundle
