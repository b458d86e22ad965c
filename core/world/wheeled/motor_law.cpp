#include "world/wheeled/motor_law.h"

namespace trundle {

namespace {

constexpr double kSteep = 1e5; // of a row without softness: times the load that it moves

} // namespace

MotorLaw::MotorLaw(const WheelState& wheel, double damping, double load, double h) : m_rest(1 / (wheel.inertia + damping * h)) {
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

/// More spin is more torque at the same momentum.
MotorLaw::Piece MotorLaw::at(double momentum) const {
    Piece piece = m_line;
    double spin = piece.spin(momentum);
    for (int i = 0; i < m_limits; ++i)
        if (const double most = m_most[i].spin(momentum); spin > most) {
            piece = m_most[i];
            spin = most;
        }
    for (int i = 0; i < m_limits; ++i)
        if (const double least = m_least[i].spin(momentum); spin < least) {
            piece = m_least[i];
            spin = least;
        }
    return piece;
}

} // namespace trundle
