#include "devices/drive_profile.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace trundle {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The duration of a velocity change that both axes finish together, s.
double rampTime(const ChassisMotion& change, const DriveLimits& limits) {
    const double linear = limits.linear > 0 ? std::abs(change.linear) / limits.linear : 0;
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

bool opposed(double velocity, double wanted, double remainder) { return velocity * wanted < 0 || remainder * wanted < 0; }

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
    if (auto why = refusal(velocity.linear, amount.linear, "linear")) return why;
    if (auto why = refusal(velocity.angular, amount.angular, "angular")) return why;
    ChassisMotion wanted = amount; // an axis without an amount moves for as long as the other one
    if (amount.linear == 0 && amount.angular != 0) wanted.linear = velocity.linear * (amount.angular / velocity.angular);
    if (amount.angular == 0 && amount.linear != 0) wanted.angular = velocity.angular * (amount.linear / velocity.linear);
    if (!std::isfinite(wanted.linear) || !std::isfinite(wanted.angular)) return "the amounts are too large for these velocities";

    m_startVelocity = m_now;
    m_brakeTime = rampTime(m_now, limits);
    m_remainder = {wanted.linear == 0 ? 0 : wanted.linear - m_now.linear * m_brakeTime / 2,
                   wanted.angular == 0 ? 0 : wanted.angular - m_now.angular * m_brakeTime / 2};
    // Braking and starting overlap if both have the same direction, since the speed is then kept; the final braking begins when
    // the first has ended. Otherwise brake first.
    const bool brakeFirst =
        opposed(m_now.linear, wanted.linear, m_remainder.linear) || opposed(m_now.angular, wanted.angular, m_remainder.angular);
    m_shape.rate = std::min(scaleLimit(std::abs(velocity.linear), m_remainder.linear),
                            scaleLimit(std::abs(velocity.angular), m_remainder.angular));
    m_shape.acceleration = std::min(limits.linear > 0 ? scaleLimit(limits.linear, m_remainder.linear) : kInfinity,
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
    return {(to.linear - from.linear) / h, (to.angular - from.angular) / h};
}

ChassisMotion DriveProfile::ramp(const DriveLimits& limits, double h) {
    const ChassisMotion change{m_target.linear - m_now.linear, m_target.angular - m_now.angular};
    const double time = rampTime(change, limits);
    if (time <= h) return m_now = m_target;
    m_now.linear += change.linear * (h / time);
    m_now.angular += change.angular * (h / time);
    return m_now;
}

double DriveProfile::duration() const { return std::max(m_brakeTime, m_delay + m_shape.duration()); }

ChassisMotion DriveProfile::positionAt(double t) const {
    const double braking = std::min(t, m_brakeTime);
    const double covered = m_brakeTime > 0 ? braking - braking * braking / (2 * m_brakeTime) : 0; // s at full start velocity
    const double s = m_shape.position(t - m_delay);
    return {m_startVelocity.linear * covered + m_remainder.linear * s,
            m_startVelocity.angular * covered + m_remainder.angular * s};
}

ChassisMotion DriveProfile::velocityAt(double t) const {
    const double left = m_brakeTime > 0 ? std::max(0.0, 1 - t / m_brakeTime) : 0;
    const double s = m_shape.velocity(t - m_delay);
    return {m_startVelocity.linear * left + m_remainder.linear * s, m_startVelocity.angular * left + m_remainder.angular * s};
}

} // namespace trundle
