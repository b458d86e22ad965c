#pragma once
// What friction and gear take from a motor.

namespace trundle {

/// At the joint: rotor friction before the gear is GearRatio times its torque there, and GearRatio^2 times its damping.
struct MotorLosses {
    double dry = 0;            ///< N m
    double viscous = 0;        ///< N m s/rad
    double efficiency = 1;     ///< part of the torque that passes the gear to the joint
    double backEfficiency = 0; ///< part that passes it from the joint to the motor; 0: `efficiency` lowers the torque both ways

    /// More than a factor of the motor's torque.
    [[nodiscard]] bool any() const { return dry > 0 || viscous > 0 || backEfficiency > 0; }
};

/// The drive near its present state: joint torque = factor * motor torque + offset - friction, with dry friction of at most `dry`.
struct LossLine {
    double factor = 1, offset = 0, dry = 0, viscous = 0;
};

/// Method: with x the motor torque less its friction, the joint gets efficiency * x where the motor drives it, x / backEfficiency where it
/// drives the motor. At rest it gets anything in between, so the gear's loss there is dry friction. The line is exact as long as the joint
/// turns as it does and the motor drives or brakes as it does, and both ends are where a joint at rest breaks away. `torque`: of the motor,
/// ideal gear, N m at the joint; `rate`: rad/s.
[[nodiscard]] LossLine lossLine(const MotorLosses& losses, double torque, double rate);

} // namespace trundle
