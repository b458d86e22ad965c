#include "world/wheeled/motor_law.h"

#include <algorithm>

namespace trundle {

namespace {

constexpr double kSteep = 1e5; // of a row without softness: times the load that it moves

} // namespace

MotorLaw::MotorLaw(const WheelState& wheel, double damping, double load, double h) 
    : m_rest(1 / (wheel.inertia + (damping + wheel.motor.viscousFriction) * h)), m_dry(wheel.motor.dryFriction * h) {
    const MotorConstraint& motor = wheel.motor;
    if (!(motor.limit > 0)) {
        m_line = constant(0);
        return;
    }
    const bool servo = motor.damping > 0;
    const double steep = kSteep * (wheel.inertia + load);
    const double slope = servo || motor.softness <= 0 ? steep : std::min(steep, h / motor.softness);
    m_line = line(slope, motor.rate);
    m_most[m_limits] = constant(motor.limit * h);
    m_least[m_limits++] = constant(-motor.limit * h);
    if (!servo) return;
    const double most = motor.limit / motor.damping;
    m_most[m_limits] = line(motor.damping * h, most);
    m_least[m_limits++] = line(motor.damping * h, -most);
}

/// Where the motor cannot overcome it, the wheel rests.
MotorLaw::Piece MotorLaw::withDry(double momentum) const {
    Piece piece = driven(momentum - m_dry);
    if (piece.spin(momentum - m_dry) > 0) return {piece.offset - m_dry, piece.mobility};
    piece = driven(momentum + m_dry);
    if (piece.spin(momentum + m_dry) < 0) return {piece.offset + m_dry, piece.mobility};
    return {};
}

double MotorLaw::motorImpulse(double momentum) const {
    const double now = spin(momentum), all = now / m_rest - momentum;
    if (m_dry == 0) return all;
    if (now != 0) return now > 0 ? all + m_dry : all - m_dry;
    const double limit = m_limits > 0 ? m_most[0].offset : 0;
    return std::clamp(m_line.offset, -limit, limit);
}

} // namespace trundle
