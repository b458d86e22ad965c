#pragma once
// Private to core/check.

#include "base/diagnostic.h"
#include "check/drive_wheels.h"
#include "project/loading/project.h"

namespace trundle {

/// Reports where a drive's wheels turn or steer another way than its motion has it: axles that point away from the middle or to the
/// wrong side, motors of the left on the right, wheels of an OmniDrive at other angles than WheelAngles. `wheels[i]` is turned by
/// `motors[i]`. At most one warning for a drive, as one cause has several effects.
void checkDirections(const LoadedProject& loaded, const RobotConfigSpec& config, const ComponentSpec& drive,
                     const std::vector<DriveMotor>& motors, const std::vector<DriveWheel>& wheels, Diagnostics& diagnostics);

/// Reports a motor whose axle is along the axis of none of the cylinders that it turns: they cannot roll.
void checkAxle(const LoadedProject& loaded, const RobotConfigSpec& config, const ComponentSpec& drive, const DriveMotor& motor,
               Diagnostics& diagnostics);

/// Whether a value is literal text in a file, not set by a Param or on the command line.
[[nodiscard]] bool isWritten(const LoadedProject& loaded, const ResolvedValue& value);

} // namespace trundle
