#pragma once
// Plans the velocity of a base tick by tick: ramps to a velocity, or a trapezoid that covers an amount (m, rad) exactly.
//
// needs       commands and acceleration limits; an acceleration of 0 means no limit
// assumptions the tick length does not change while an amount is being driven
// method      an amount has its own position P(t); the velocity of tick k is (P(t_k+1) - P(t_k)) / h, so that the ticks add up
//             to the amount except for rounding, for any h
// data        P = braking distance from the start velocity + remainder * S(t), S a trapezoid from 0 to 1 shared by all amounts

#include <optional>
#include <string>

#include "devices/kinematics.h"

namespace trundle {

/// From 0 to 1 with peak rate `rate` (1/s) and acceleration `acceleration` (1/s^2, infinite: none).
struct UnitTrapezoid {
    double rate = 1, acceleration = 1;
    [[nodiscard]] double duration() const;
    [[nodiscard]] double riseTime() const; ///< s; braking takes as long
    [[nodiscard]] double position(double t) const;
    [[nodiscard]] double velocity(double t) const;

private:
    [[nodiscard]] double peak() const;
};

/// m/s^2 and rad/s^2; 0: no limit.
struct DriveLimits {
    double linear = 0, angular = 0;
};

class DriveProfile {
public:
    /// Sets the velocity to ramp to; all of it arrives together, so the curvature is kept. Cancels an amount.
    void aim(const ChassisMotion& velocity);
    /// Starts an amount, in the plane along the velocity; an amount of 0 means no limit on its axis. Returns the reason if it is refused; then the base only
    /// brakes.
    [[nodiscard]] std::optional<std::string> start(const ChassisMotion& velocity, const ChassisMotion& amount,
                                                   const DriveLimits& limits);
    /// The mean velocity over the next tick of length `h` (s).
    [[nodiscard]] ChassisMotion next(const DriveLimits& limits, double h);
    /// An amount is being driven.
    [[nodiscard]] bool busy() const { return m_busy; }

private:
    [[nodiscard]] ChassisMotion ramp(const DriveLimits& limits, double h);
    [[nodiscard]] ChassisMotion positionAt(double t) const;
    [[nodiscard]] ChassisMotion velocityAt(double t) const;
    [[nodiscard]] double duration() const;

    ChassisMotion m_now;    ///< velocity at the end of the last tick
    ChassisMotion m_target; ///< velocity set by aim()
    bool m_busy = false;
    // of the current amount
    ChassisMotion m_startVelocity, m_remainder;
    UnitTrapezoid m_shape;
    double m_brakeTime = 0, m_delay = 0; ///< s
    double m_elapsed = 0;                ///< ticks
};

} // namespace trundle
