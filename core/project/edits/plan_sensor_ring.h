#pragma once
#include "project/edits/plans.h"

namespace trundle {

/// Equal distance sensors around a body, that look outwards.
struct SensorRing {
    int count = 8;
    double radius = 0.1, height = 0.05, maxRange = 1; ///< m; the height is that of the circle in the body's frame
    std::string type = "infrared";                    ///< of a RangeSensor
};

/// The body that a path names, is in, or is that of: of a robot, piece of scenery or config the first one. Fails, with the reason, if
/// it has no body.
[[nodiscard]] Result<std::string> bodyForSensors(const LoadedProject& loaded, const std::string& path);
/// Around what collides of a body, at half its height; the default where the body has no instance in the experiment.
[[nodiscard]] SensorRing proposedRing(const LoadedProject& loaded, const std::string& body);
/// Writes a Ring with one RangeSensor in it, beside the body.
[[nodiscard]] Result<EditPlan> planSensorRing(const LoadedProject& loaded, const std::string& body, const SensorRing& ring);

} // namespace trundle
