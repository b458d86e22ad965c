#pragma once
// What drives a joint of an engine, and what acts on it.

#include <trundle/geometry.h>

namespace trundle {

/// A constraint row that drives a joint to `rate` with the torque (rate - actual) / softness, at most `limit`. Limit 0: no row.
/// With a damping it is a servo: softness is ignored, and the torque along the joint's motion is at most limit - damping * |actual|.
struct MotorConstraint {
    double rate = 0;            ///< rad/s or m/s
    double softness = 0;        ///< rad/s per N m; 0: as stiff as the engine allows
    double limit = 0;           ///< N m or N
    double damping = 0;         ///< N m s/rad
    double dryFriction = 0;     ///< of the drive, N m or N
    double viscousFriction = 0; ///< N m s/rad or N s/m
    bool operator==(const MotorConstraint&) const = default;
};

/// What an engine publishes of a joint after a step.
struct JointReading {
    double position = 0, rate = 0;   ///< how far it has moved and how fast it does, rad or m; unwrapped
    double position2 = 0, rate2 = 0; ///< of a Universal, about Axis2
    double motor = 0, friction = 0;  ///< of the motor and of the friction of its drive, N m or N along the joint's motion
};

/// Of a joint's parent on its child, world frame: N, and N m about the anchor.
struct JointWrench {
    Vec3 force = Vec3::Zero(), torque = Vec3::Zero();
};

} // namespace trundle
