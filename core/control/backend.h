#pragma once
// How a run reaches a controller, wherever that lives. In process today; the host process and TCP stand behind the same four calls.

#include <functional>
#include <memory>
#include <string>

#include "base/result.h"
#include "model/experiment_spec.h"
#include "signals/block.h"
#include "signals/frame.h"

namespace trundle {

class Medium;

/// What a controller reaches of the outside: its console, its logs, the end of the run. Called on the thread that ticks.
struct ControllerOutlet {
    std::function<void(int severity, const std::string& text)> print;
    std::function<int(const std::string& fileName)> openLog; ///< -1: refused
    std::function<void(int log, std::string_view bytes)> writeLog;
    std::function<void(const std::string& reason)> finish; ///< the run ends after this tick
    Medium* medium = nullptr;                              ///< for its radios; outlives the controller
    // Cameras of the robot, by their names.
    std::function<Result<const Frame*>(const std::string& camera)> capture; ///< good until it takes its next picture
    std::function<Status(const std::string& camera, const std::string& fileName)> savePicture;
    std::function<std::string(std::uint32_t object)> objectName;
};

class ControllerBackend {
public:
    virtual ~ControllerBackend() = default;
    /// Creates the controller, gives it its fields, lets it bind its ports. Fails with E410 (failed) or E411 (unknown port).
    [[nodiscard]] virtual Status start(const SignalLayout& layout, SignalBlock& block, ControllerOutlet outlet) = 0;
    /// Its turn in tick number `tick` at simulated time `time`; `sinceLast` s since its last turn (0 the first time).
    [[nodiscard]] virtual Status tick(std::uint64_t tick, double time, double sinceLast) = 0;
    /// Sets a field that the controller's kind describes as live.
    [[nodiscard]] virtual Status set(const std::string& property, const PropertyValue& value) = 0;
    virtual void stop() = 0;
    [[nodiscard]] virtual std::string describe() const = 0; ///< "LinearMotion from linear_motion.so, in process"
};

} // namespace trundle
