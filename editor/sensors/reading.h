#pragma once
// The quantities of a device that the Sensors dock shows: where they are in the signals, their limits and their true values.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "editor/running/active_run.h"
#include "scene/queries/range_model.h"
#include "schema/registry.h"

namespace trundle {

/// The largest number of numbers that a reading shows; a signal with more is shown as its least and greatest.
inline constexpr std::size_t kMaxShownNumbers = 4;

/// One quantity: a signal, or a part of one with several quantities.
struct Reading {
    using Read = std::function<void(const LiveSnapshot&, double* numbers)>;

    std::string name;   ///< "range", "pose x, y"
    std::string signal; ///< "robot0/front/range"
    std::string unit;   ///< SI
    std::string help;   ///< a sentence, or empty
    SignalType type = SignalType::Real;
    bool commanded = false;                          ///< set by a controller, not measured
    bool isAngle = false;                            ///< between -pi and pi: a jump from one to the other is no change
    std::size_t count = 1;                           ///< numbers, at most kMaxShownNumbers
    Read read;                                       ///< writes `count` numbers
    Read readTrue;                                   ///< the same without errors; empty if there is no such value
    std::optional<std::pair<double, double>> limits; ///< of the quantity, in SI; none: unknown
};

/// How a device is drawn, beside its readings.
enum class SensorPicture { None, Polar, Dial, Battery, Camera };

struct SensorDevice {
    std::string path; ///< "robot0.front", as in the selection
    const Kind* kind = nullptr;
    std::vector<Reading> readings;
    SensorPicture picture = SensorPicture::None;
    std::shared_ptr<const RangeModel> fan;               ///< of Polar
    std::function<bool(const LiveSnapshot&)> hasReading; ///< false before its first one
};

/// The device or the controller at `path` in a run. No readings if it has no signals there, none at all if there is no such part.
[[nodiscard]] std::optional<SensorDevice> sensorDeviceAt(const RunResults& run, const std::string& path);

} // namespace trundle
