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

} // namespace trundle
