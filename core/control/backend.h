#pragma once
// Interface between a run and a controller, independent of where the controller runs: in this process or in a host process.

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "model/experiment_spec.h"
#include "radio/radio_state.h"
#include "signals/block.h"
#include "signals/camera_image.h"

namespace trundle {

/// The radios of a world, for controllers.
class RadioAccess {
public:
    virtual ~RadioAccess() = default;
    [[nodiscard]] virtual std::optional<std::uint32_t> find(const std::string& path) = 0; ///< "robot0/radio"
    [[nodiscard]] virtual bool exists(std::uint32_t radio) const = 0;
    [[nodiscard]] virtual std::uint32_t address(std::uint32_t radio) const = 0;
    /// Queues a packet. False: refused.
    virtual bool send(std::uint32_t radio, std::span<const std::uint8_t> bytes, std::uint32_t to, double powerDbm) = 0;
    /// Takes the oldest packet from the buffer. False: it is empty.
    virtual bool receive(std::uint32_t radio, RadioPacket& packet) = 0;
    [[nodiscard]] virtual std::size_t pending(std::uint32_t radio) const = 0; ///< packets in its buffer
};

/// What a controller can access outside its robot: console, logs, end of the run, radios and cameras. Called on the simulation
/// thread.
struct ControllerOutputs {
    std::function<void(int severity, const std::string& text)> print;
    std::function<int(const std::string& fileName)> openLog; ///< -1: refused
    std::function<void(int log, std::string_view bytes)> writeLog;
    std::function<void(const std::string& reason)> finish; ///< requests the end of the run after this tick
    std::function<void(const std::string& text)> gaveUp;   ///< fail() was called; the call under way returns its error
    /// Called for each command, by its path, that the controller gets at. Fails if it is that of another controller. Null: all
    /// commands of the robot are this one's.
    std::function<Status(const std::string& command)> claim;
    std::shared_ptr<RadioAccess> radios;                   ///< null: none
    // Cameras of the robot, by name.
    std::function<Result<const CameraImage*>(const std::string& camera)> capture; ///< valid until that camera's next image
    std::function<Status(const std::string& camera, const std::string& fileName)> savePicture;
    std::function<std::string(std::uint32_t object)> objectName;
};

/// Why a controller is not called any more while the run goes on. Possible only outside this process.
struct ControllerFault {
    std::string reason;                 ///< "the controller Zoo of bad (libzoo.so) crashed in update: Segmentation fault"
    std::vector<std::string> backtrace; ///< "act(std::string const&) at zoo.cpp:316", innermost first
    std::string process;                ///< a name for the process that ended; empty: that goes on
    bool isOwn = true;                  ///< false: another controller of the same process has the fault
    CodePlace place = {};               ///< where in the author's code it happened
};

class ControllerBackend {
public:
    virtual ~ControllerBackend() = default;
    /// Creates the controller, sets its fields and lets it bind its ports. Fails with E410 (failed) or E411 (unknown port).
    [[nodiscard]] virtual Status start(const SignalLayout& layout, SignalBlock& block, ControllerOutputs outputs) = 0;
    /// Announces a tick() with the same arguments: all controllers that are due are announced before the first is called, so that
    /// a host process gets them together.
    virtual void prepare(std::uint64_t, double, double) {}
    /// Calls update in tick number `tick` at simulated time `time` (s); `sinceLast` is the time since the last call, s (0 the
    /// first time).
    [[nodiscard]] virtual Status tick(std::uint64_t tick, double time, double sinceLast) = 0;
    /// Whether its kind is independent of other robots: then tickApart() does what a tick() does, on any thread and at the same time as those
    /// of other robots; the tick() that follows passes on what it put out, and returns its result.
    [[nodiscard]] virtual bool isIndependent() const { return false; }
    virtual void tickApart(std::uint64_t, double, double) {}
    /// Sets a live field of the controller.
    [[nodiscard]] virtual Status set(const std::string& property, const PropertyValue& value) = 0;
    virtual void stop() = 0;
    /// What the controller's code saves for a later version of itself; empty: nothing.
    [[nodiscard]] virtual Result<std::string> saveState() { return std::string(); }
    /// After start(): hands that over.
    [[nodiscard]] virtual Status loadState(std::string_view) { return {}; }
    /// Loads the module again, in a new process that replaces the old one; start() then starts the controller there. The first
    /// call with this `request` does it for all controllers of the process. Fails, and changes nothing, if the module cannot be
    /// loaded or has other properties or published values than those of this run.
    [[nodiscard]] virtual Status renew(std::uint64_t) {
        return Error{Code::ControllerFailed, "it runs inside the program: reset the run to load its module again"};
    }
    /// The path of its library; empty: unknown.
    [[nodiscard]] virtual std::string module() const { return {}; }
    /// Wall time of the last update, s, where the call of tick() does not give it.
    [[nodiscard]] virtual std::optional<double> updateS() const { return {}; }
    /// The process that it runs in; 0: this one, or one that has ended.
    [[nodiscard]] virtual int processId() const { return 0; }
    /// Set if a fault has stopped this controller alone: the run continues, and start() starts it again.
    [[nodiscard]] virtual const ControllerFault* fault() const { return nullptr; }
    [[nodiscard]] virtual std::string describe() const = 0; ///< "LinearMotion from liblinear_motion.so, in process"
};

} // namespace trundle
