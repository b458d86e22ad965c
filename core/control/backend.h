#pragma once
// Interface between a run and a controller, independent of where the controller runs. Today it runs in this process; a host
// process and TCP can be added behind the same calls.

#include <functional>
#include <memory>
#include <string>

#include "base/result.h"
#include "model/experiment_spec.h"
#include "signals/block.h"
#include "signals/camera_image.h"

namespace trundle {

class Medium;

/// What a controller can access outside its robot: console, logs, end of the run, radios and cameras. Called on the simulation
/// thread.
struct ControllerOutputs {
    std::function<void(int severity, const std::string& text)> print;
    std::function<int(const std::string& fileName)> openLog; ///< -1: refused
    std::function<void(int log, std::string_view bytes)> writeLog;
    std::function<void(const std::string& reason)> finish; ///< requests the end of the run after this tick
    Medium* medium = nullptr;                              ///< for the robot's radios; outlives the controller
    // Cameras of the robot, by name.
    std::function<Result<const CameraImage*>(const std::string& camera)> capture; ///< valid until that camera's next image
    std::function<Status(const std::string& camera, const std::string& fileName)> savePicture;
    std::function<std::string(std::uint32_t object)> objectName;
};

class ControllerBackend {
public:
    virtual ~ControllerBackend() = default;
    /// Creates the controller, sets its fields and lets it bind its ports. Fails with E410 (failed) or E411 (unknown port).
    [[nodiscard]] virtual Status start(const SignalLayout& layout, SignalBlock& block, ControllerOutputs outputs) = 0;
    /// Calls update in tick number `tick` at simulated time `time` (s); `sinceLast` is the time since the last call, s (0 the
    /// first time).
    [[nodiscard]] virtual Status tick(std::uint64_t tick, double time, double sinceLast) = 0;
    /// Sets a live field of the controller.
    [[nodiscard]] virtual Status set(const std::string& property, const PropertyValue& value) = 0;
    virtual void stop() = 0;
    [[nodiscard]] virtual std::string describe() const = 0; ///< "LinearMotion from linear_motion.so, in process"
};

} // namespace trundle
