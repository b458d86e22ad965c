#include "devices/servo.h"

#include <algorithm>
#include <cmath>

namespace trundle {

namespace {

constexpr double kLateShare = 1e-3; // of MaxSpeed: a joint that is farther off its rate is held back

} // namespace

void JointServo::setup(Mount& mount) {
    m_joint = mount.joint(m_jointName);
    m_play.start(m_backlash);
}

/// In Mode=position the rate is proportional to the way to go, so that the way shrinks by 63 % in each TimeConstant.
void JointServo::act(Actuation& world) {
    m_target = wanted(world);
    m_rate = m_target;
    if (m_mode == "position") m_rate = (m_target - world.jointPosition(m_joint)) / std::max(m_timeConstant, double(world.tick()));
    const double share = shareOf(world.supply());
    m_rate = std::clamp(m_rate, -m_maxSpeed * share, m_maxSpeed * share);
    const double moving = world.jointRate(m_joint);
    if (!m_play.reaches(m_rate - moving, kLateShare * m_maxSpeed, world.jointMotorEffort(m_joint))) {
        m_play.turn({m_rate}, moving, world.tick());
        return world.motorRow(m_joint, 0, 1, 0);
    }
    world.servoRow(m_joint, m_rate, m_maxEffort * share, m_maxEffort / m_maxSpeed);
}

/// Of its efforts and speeds, at the voltage of the battery. An empty one leaves the joint free.
double JointServo::shareOf(const Supply& supply) { return supply.present ? supply.voltage / supply.nominal : 1; }

/// As a direct-current motor it takes the power of its motion, and what heats its winding: effort^2 MaxSpeed / MaxEffort, so that at rest
/// MaxEffort takes MaxEffort x MaxSpeed, and nothing without load at MaxSpeed.
void JointServo::drawPower(Sensing& world, double rate, double effort) const {
    const Supply supply = world.supply();
    if (!supply.present || !(supply.voltage > 0)) return;
    const double heat = m_maxSpeed / m_maxEffort, share = effort / m_maxEffort + rate / m_maxSpeed;
    const double atNominal = share / supply.voltage; // of the voltage: effort and rate are as large at `share` of the nominal one
    world.draw(effort * rate + effort * effort * heat, atNominal * atNominal * m_maxEffort * m_maxSpeed);
}

void JointServo::sense(Sensing& world) {
    const double rate = world.jointRate(m_joint);
    m_play.follow(rate, world.tick());
    const bool tooFast = m_mode == "speed" && std::abs(m_target) > m_maxSpeed * (1 + 1e-9);
    const bool isLate = world.time() > 0 && std::abs(m_rate - rate) > kLateShare * m_maxSpeed;
    const double effort = world.jointMotorEffort(m_joint);
    publish(world.jointPosition(m_joint), rate, effort, tooFast || isLate);
    drawPower(world, rate, effort);
}

void Servo::describe(Describe<Servo>& d) {
    d.help("Turns a joint to a position, or at a rate, by a controller of its own.").independent();
    d.field("Joint", &Servo::m_jointName, reference("Hinge|Suspension").required(), "The joint it turns.");
    d.field("Mode", &Servo::m_mode, oneOf("position|speed"), "What its target is.");
    d.field("MaxTorque", &Servo::m_maxEffort, newtonMetres().within(1e-9, 1e9).required().live(),
            "At rest; at MaxSpeed it has none left.");
    d.field("MaxSpeed", &Servo::m_maxSpeed, radiansPerSecond().within(1e-6, 1e6).required().live(), "Without load.");
    d.field("TimeConstant", &Servo::m_timeConstant, seconds().within(0, 1e3).live(),
            "In Mode=position the way to go shrinks by 63 % in this time; 0: in one tick.");
    d.field("Backlash", &Servo::m_backlash, degrees().within(0, 90), "Play of its gear, at the joint.");
    ServoSignals::describe(d);
}

void Servo::publish(double at, double turning, double effort, bool isSaturated) {
    position.set(at);
    rate.set(turning);
    torque.set(effort);
    saturated.set(isSaturated);
}

void LinearMotor::describe(Describe<LinearMotor>& d) {
    d.help("Moves a slider to a position, or at a speed, by a controller of its own.").independent();
    d.field("Joint", &LinearMotor::m_jointName, reference("Slider").required(), "The slider it moves.");
    d.field("Mode", &LinearMotor::m_mode, oneOf("position|speed"), "What its target is.");
    d.field("MaxForce", &LinearMotor::m_maxEffort, newtons().within(1e-9, 1e9).required().live(),
            "At rest; at MaxSpeed it has none left.");
    d.field("MaxSpeed", &LinearMotor::m_maxSpeed, metresPerSecond().within(1e-6, 1e6).required().live(), "Without load.");
    d.field("TimeConstant", &LinearMotor::m_timeConstant, seconds().within(0, 1e3).live(),
            "In Mode=position the way to go shrinks by 63 % in this time; 0: in one tick.");
    d.field("Backlash", &LinearMotor::m_backlash, metres().within(0, 10), "Play of its gear or spindle.");
    LinearMotorSignals::describe(d);
}

void LinearMotor::publish(double at, double moving, double effort, bool isSaturated) {
    position.set(at);
    rate.set(moving);
    force.set(effort);
    saturated.set(isSaturated);
}

} // namespace trundle
