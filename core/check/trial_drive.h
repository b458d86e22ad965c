#pragma once
// Private to core/check.

#include "base/diagnostic.h"
#include "check/trial_world.h"

namespace trundle {

/// Commands the drive ahead, to the left, and where it can, sideways, each for two seconds, and reports the first motion that is another
/// one by its direction or by more than half. False if the world ended.
[[nodiscard]] bool tryDrive(TrialWorld& world, const RobotConfigSpec& config, const ComponentSpec& drive,
                            Diagnostics& diagnostics, const std::stop_token& stop);
/// Whether a device is a drive that this knows.
[[nodiscard]] bool isDrive(const ComponentSpec& device);

} // namespace trundle
