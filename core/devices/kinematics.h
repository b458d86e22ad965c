#pragma once
// Plane kinematics of a two-wheeled base (thesis eqs. 3.2-3.7). r: wheel radius, d: wheel separation, m. Heading + turns left.

namespace trundle {

/// Of the middle of the axle: m/s and rad/s, or m and rad.
struct ChassisMotion {
    double linear = 0, angular = 0;
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
/// Eqs. 3.4-3.7 in one form that divides by no velocity. (As printed, 3.6 turns the left wheel the wrong way on the spot.)
[[nodiscard]] WheelMotion wheelsFromChassis(const ChassisMotion& chassis, double r, double d);
/// Where a pose is after driving `linear` m along the circle that turns it by `angular` rad. Exact for any angle.
[[nodiscard]] PlanePose alongArc(const PlanePose& from, const ChassisMotion& travel);

} // namespace trundle
