#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "editor/running/active_run.h"
#include "editor/sensors/reading.h"
#include "scene/queries/range_model.h"
#include "schema/registry.h"

namespace trundle {

/// How a device is drawn, beside its readings.
enum class SensorPicture { None, Polar, Dial, Battery, Camera };

struct SensorDevice {
    std::string path;      ///< "robot0.front", as in the selection
    std::string component; ///< "robot0/front", as in its signals and as a camera
    const Kind* kind = nullptr;
    std::vector<Reading> readings;
    SensorPicture picture = SensorPicture::None;
    std::shared_ptr<const RangeModel> fan;               ///< of Polar
    std::function<bool(const LiveSnapshot&)> hasReading; ///< false before its first one
};

/// The device or the controller at `path` in a run. No readings if it has no signals there, none at all if there is no such part.
[[nodiscard]] std::optional<SensorDevice> sensorDeviceAt(const RunResults& run, const std::string& path);

} // namespace trundle
