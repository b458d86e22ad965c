#pragma once
// Planar kinematics of a two-wheeled base (thesis eqs. 3.2-3.7). r: wheel radius, d: wheel separation, m. Positive heading turns
// left.

namespace trundle {

/// Motion of the base's centre, in its own frame: m/s and rad/s, or m and rad.
struct ChassisMotion {
    double linear = 0, angular = 0;
    double lateral = 0; ///< to the left; 0 unless the base can move sideways
};
/// rad/s, or rad.
struct WheelMotion {
    double left = 0, right = 0;
};
struct PlanePose {
    double x = 0, y = 0, heading = 0;
};

/// Eqs. 3.2, 3.3.
[[nodiscard]] ChassisMotion chassisFromWheels(const WheelMotion& wheels, double r, double d);
/// Eqs. 3.4-3.7 in one form without division by a velocity. (As printed, 3.6 turns the left wheel the wrong way when turning in
/// place.)
[[nodiscard]] WheelMotion wheelsFromChassis(const ChassisMotion& chassis, double r, double d);
/// The pose after driving `linear` m along an arc that turns it by `angular` rad. Exact for any angle.
[[nodiscard]] PlanePose alongArc(const PlanePose& from, const ChassisMotion& travel);
/// The way from one pose to the next on an arc, in the frame of the base on its middle: m and rad. The inverse of alongArc for less than a
/// half turn.
[[nodiscard]] ChassisMotion motionBetween(const PlanePose& from, const PlanePose& to);

} // namespace trundle
