#include "devices/drive_profile.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace trundle {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// In the plane: the speed of a velocity, the length of an amount. Few drives move sideways, and hypot takes time.
double sizeOf(const ChassisMotion& motion) {
    return motion.lateral == 0 ? std::abs(motion.linear) : std::hypot(motion.linear, motion.lateral);
}
double dot(const ChassisMotion& a, const ChassisMotion& b) { return a.linear * b.linear + a.lateral * b.lateral; }

ChassisMotion scaled(const ChassisMotion& motion, double plane, double angular) {
    return {motion.linear * plane, motion.angular * angular, motion.lateral * plane};
}
ChassisMotion sum(const ChassisMotion& a, const ChassisMotion& b) {
    return {a.linear + b.linear, a.angular + b.angular, a.lateral + b.lateral};
}

/// The duration of a velocity change that all axes finish together, s.
double rampTime(const ChassisMotion& change, const DriveLimits& limits) {
    const double linear = limits.linear > 0 ? sizeOf(change) / limits.linear : 0;
    const double angular = limits.angular > 0 ? std::abs(change.angular) / limits.angular : 0;
    return std::max(linear, angular);
}

/// The highest rate of the shared scale at which amount * scale stays within `limit`.
double scaleLimit(double limit, double amount) { return amount == 0 ? kInfinity : limit / std::abs(amount); }

/// Why an axis cannot drive its amount; empty if it can.
std::optional<std::string> refusal(double velocity, double amount, const char* axis) {
    if (amount == 0) return {};
    if (velocity == 0) return std::string(axis) + " amount with no " + axis + " velocity";
    if ((velocity > 0) != (amount > 0)) return std::string(axis) + " amount and " + axis + " velocity have opposite signs";
    return {};
}

/// The amount along the velocity; without a velocity, its length.
double along(const ChassisMotion& velocity, const ChassisMotion& amount) {
    const double speed = sizeOf(velocity);
    return speed > 0 ? dot(velocity, amount) / speed : sizeOf(amount);
}

} // namespace

double UnitTrapezoid::peak() const { return std::min(rate, std::sqrt(acceleration)); }

double UnitTrapezoid::duration() const {
    return std::isfinite(peak()) ? 1 / peak() + peak() / acceleration : 0;
} // infinite rate: nothing left to drive

double UnitTrapezoid::riseTime() const { return std::isfinite(peak()) ? peak() / acceleration : 0; }

double UnitTrapezoid::position(double t) const {
    const double total = duration(), rise = riseTime();
    if (t <= 0) return 0;
    if (t >= total) return 1;
    if (t < rise) return acceleration * t * t / 2;
    if (t > total - rise) return 1 - acceleration * (total - t) * (total - t) / 2;
    return peak() * (t - rise / 2);
}

double UnitTrapezoid::velocity(double t) const {
    const double total = duration(), rise = riseTime();
    if (t <= 0 || t >= total) return 0;
    if (t < rise) return acceleration * t;
    return t > total - rise ? acceleration * (total - t) : peak();
}

void DriveProfile::aim(const ChassisMotion& velocity) {
    m_target = velocity;
    m_busy = false;
}

std::optional<std::string> DriveProfile::start(const ChassisMotion& velocity, const ChassisMotion& amount,
                                               const DriveLimits& limits) {
    aim({});
    const double speed = sizeOf(velocity), length = sizeOf(amount);
    if (auto why = refusal(speed, along(velocity, amount), "linear")) return why;
    if (auto why = refusal(velocity.angular, amount.angular, "angular")) return why;
    ChassisMotion wanted = amount; // an axis without an amount moves for as long as the other one
    if (length == 0 && amount.angular != 0) {
        wanted = scaled(velocity, amount.angular / velocity.angular, 0);
        wanted.angular = amount.angular;
    }
    if (amount.angular == 0 && length != 0) wanted.angular = velocity.angular * (length / speed);
    if (!std::isfinite(sizeOf(wanted)) || !std::isfinite(wanted.angular)) return "the amounts are too large for these velocities";

    m_startVelocity = m_now;
    m_brakeTime = rampTime(m_now, limits);
    m_remainder = sum(wanted, scaled(m_now, -m_brakeTime / 2, -m_brakeTime / 2));
    if (sizeOf(wanted) == 0) m_remainder.linear = m_remainder.lateral = 0;
    if (wanted.angular == 0) m_remainder.angular = 0;
    // Braking and starting overlap if both have the same direction, since the speed is then kept; the final braking begins when
    // the first has ended. Otherwise brake first.
    const bool brakeFirst = dot(m_now, wanted) < 0 || dot(m_remainder, wanted) < 0 || m_now.angular * wanted.angular < 0 ||
                            m_remainder.angular * wanted.angular < 0;
    const double remainder = sizeOf(m_remainder);
    m_shape.rate = std::min(scaleLimit(speed, remainder), scaleLimit(std::abs(velocity.angular), m_remainder.angular));
    m_shape.acceleration = std::min(limits.linear > 0 ? scaleLimit(limits.linear, remainder) : kInfinity,
                                    limits.angular > 0 ? scaleLimit(limits.angular, m_remainder.angular) : kInfinity);
    m_delay = brakeFirst ? m_brakeTime : std::max(0.0, m_brakeTime - (m_shape.duration() - m_shape.riseTime()));
    m_elapsed = 0;
    m_busy = true;
    return {};
}

ChassisMotion DriveProfile::next(const DriveLimits& limits, double h) {
    if (!m_busy) return ramp(limits, h);
    const ChassisMotion from = positionAt(m_elapsed * h);
    m_elapsed += 1;
    const ChassisMotion to = positionAt(m_elapsed * h);
    m_now = velocityAt(m_elapsed * h);
    m_busy = (m_elapsed + 1e-9) * h < duration(); // no extra tick for a rounding error
    return {(to.linear - from.linear) / h, (to.angular - from.angular) / h, (to.lateral - from.lateral) / h};
}

ChassisMotion DriveProfile::ramp(const DriveLimits& limits, double h) {
    const ChassisMotion change = sum(m_target, scaled(m_now, -1, -1));
    const double time = rampTime(change, limits);
    if (time <= h) return m_now = m_target;
    return m_now = sum(m_now, scaled(change, h / time, h / time));
}

double DriveProfile::duration() const { return std::max(m_brakeTime, m_delay + m_shape.duration()); }

ChassisMotion DriveProfile::positionAt(double t) const {
    const double braking = std::min(t, m_brakeTime);
    const double covered = m_brakeTime > 0 ? braking - braking * braking / (2 * m_brakeTime) : 0; // s at full start velocity
    const double s = m_shape.position(t - m_delay);
    return sum(scaled(m_startVelocity, covered, covered), scaled(m_remainder, s, s));
}

ChassisMotion DriveProfile::velocityAt(double t) const {
    const double left = m_brakeTime > 0 ? std::max(0.0, 1 - t / m_brakeTime) : 0;
    const double s = m_shape.velocity(t - m_delay);
    return sum(scaled(m_startVelocity, left, left), scaled(m_remainder, s, s));
}

} // namespace trundle
