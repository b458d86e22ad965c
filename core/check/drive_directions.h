#pragma once
// Private to core/check.

#include "check/drive_report.h"

namespace trundle {

/// Reports where a drive's wheels turn or steer another way than its motion has it: axles that point away from the middle or to the
/// wrong side, motors of the left on the right, wheels of an OmniDrive at other angles than WheelAngles. `wheels[i]` is turned by
/// `motors[i]`. At most one warning for a drive, as one cause has several effects.
void checkDirections(DriveReport& report, const std::vector<DriveMotor>& motors, const std::vector<DriveWheel>& wheels);
/// The same of an OmniDrive.
void checkOmni(DriveReport& report, const std::vector<DriveWheel>& wheels);
/// The same of a MecanumDrive whose sides are right; `ahead`: the direction in which it drives.
void checkMecanum(DriveReport& report, const std::vector<DriveMotor>& motors, const std::vector<DriveWheel>& wheels,
                  const Vec3& ahead);

/// Reports a motor whose axle is along the axis of none of the cylinders that it turns: they cannot roll.
void checkAxle(DriveReport& report, const DriveMotor& motor);
/// Discs on joints across their own axis, which is level, and that no drive turns; on the floor they do not roll. `axis`: of the joint.
[[nodiscard]] std::vector<DriveWheel> wheelsAcross(const RobotConfigSpec& config);

} // namespace trundle
