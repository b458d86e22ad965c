#pragma once
#include <vector>

#include "editor/running/active_run.h"
#include "editor/sensors/reading.h"

namespace trundle {

/// Sets Reading::readTrue of what a device measures wherever the run has the true value: of its signal "range" the signal "trueRange",
/// otherwise computed from pose and velocity of the device's body.
void addTrueValues(const RunResults& run, const RobotSpec& robot, const ComponentSpec& device, std::vector<Reading>& readings);

} // namespace trundle
