#include "devices/chassis_drive.h"

#include <algorithm>
#include <cstdio>
#include <limits>

namespace trundle {
namespace {

/// rad; above this rotation per tick the wheel hinges separate and the heading is inaccurate.
constexpr double kMaxTurnPerTick = 0.1;

template <class... Values> std::string formatted(const char* pattern, Values... values) {
    char text[200];
    std::snprintf(text, sizeof text, pattern, values...);
    return text;
}

} // namespace

void ChassisDrive::mountWheels(Mount& mount, const std::vector<std::string>& left, const std::vector<std::string>& right) {
    m_control = m_controlName == "pi" ? Control::Pi : m_controlName == "voltage" ? Control::Voltage : Control::Servo;
    for (const std::string& motor : left) m_left.push_back(mountWheel(mount, motor));
    for (const std::string& motor : right) m_right.push_back(mountWheel(mount, motor));
}

ChassisDrive::Wheel ChassisDrive::mountWheel(Mount& mount, const std::string& motor) {
    Wheel wheel;
    wheel.motor = mount.peer<RotaryMotorSignals>(motor);
    if (!wheel.motor.bound()) return wheel;
    wheel.joint = mount.joint(mount.peerText(motor, "Joint"));
    const double backEmf = mount.peerNumber(motor, "BackEmfConstant", 0);
    const double perVolt = mount.peerNumber(motor, "SpeedConstant", backEmf > 0 ? 1 / backEmf : 1);
    wheel.voltsPerRate = mount.peerNumber(motor, "GearRatio", 1) / perVolt;
    wheel.maxVoltage = mount.peerNumber(motor, "MaxVoltage", 0);
    return wheel;
}

void ChassisDrive::readCommands(const Services& world) {
    const ChassisMotion velocity{linearVelocity.read(world), angularVelocity.read(world)};
    const ChassisMotion amount{linearAmount.read(world), angularAmount.read(world)};
    const double number = sequence.read(world);
    const bool isNew = number != m_seen;
    m_seen = number;
    if (amount.linear == 0 && amount.angular == 0) {
        m_profile.aim(velocity);
    } else if (isNew) {
        if (const auto why = m_profile.start(velocity, amount, limits())) world.warn("command refused: " + *why);
    }
}

void ChassisDrive::act(Actuation& world) {
    readCommands(world);
    const ChassisMotion velocity = m_profile.next(limits(), world.tick());
    const WheelMotion rates = wheelsFromChassis(velocity, m_radiusM, separation());
    warnOfSpeeds(world, velocity, rates);
    for (Wheel& wheel : m_left) drive(world, wheel, rates.left);
    for (Wheel& wheel : m_right) drive(world, wheel, rates.right);
}

void ChassisDrive::drive(Actuation& world, Wheel& wheel, double rate) {
    wheel.motor.set(&RotaryMotorSignals::servo, m_control == Control::Servo);
    switch (m_control) {
    case Control::Servo: wheel.motor.set(&RotaryMotorSignals::targetRate, rate); break;
    case Control::Pi: wheel.motor.set(&RotaryMotorSignals::voltage, piVoltage(world, wheel, rate)); break;
    case Control::Voltage: wheel.motor.set(&RotaryMotorSignals::voltage, rate * wheel.voltsPerRate); break;
    }
    wheel.lastTarget = rate;
}

/// Feed-forward plus PI; the motor clips it. The error is the target of the last tick minus the rate reached at its end, so the integral is the
/// wheel's angle error: it converges to zero at rest, and with it the remaining error of an amount.
double ChassisDrive::piVoltage(const Services& world, Wheel& wheel, double rate) const {
    const double error = wheel.lastTarget - world.jointRate(wheel.joint);
    const double angle = wheel.errorAngle + error * world.tick();
    const double voltage = rate * wheel.voltsPerRate + m_kp * error + m_ki * angle;
    const double clipped = std::clamp(voltage, -wheel.maxVoltage, wheel.maxVoltage);
    const bool windingUp = voltage != clipped && (voltage > clipped) == (error > 0);
    if (!windingUp) wheel.errorAngle = angle;
    return voltage;
}

void ChassisDrive::warnOfSpeeds(const Services& world, const ChassisMotion& velocity, const WheelMotion& rates) {
    if (!m_reportedTurnRate && std::abs(velocity.angular) * world.tick() > kMaxTurnPerTick) {
        m_reportedTurnRate = true;
        world.warn(formatted("turning at %.3g rad/s is too fast for a tick of %.3g s: heading gets inexact above %.3g rad/s",
                             velocity.angular, world.tick().value, kMaxTurnPerTick / world.tick()));
    }
    const double fastest = std::max(std::abs(rates.left), std::abs(rates.right));
    double possible = std::numeric_limits<double>::infinity();
    for (const auto* side : {&m_left, &m_right})
        for (const Wheel& wheel : *side) possible = std::min(possible, wheel.maxVoltage / wheel.voltsPerRate);
    if (m_control != Control::Servo && !m_reportedSpeed && fastest > possible) { // a servo reports that itself
        m_reportedSpeed = true;
        world.warn(formatted("a wheel is to turn at %.3g rad/s, its motor reaches %.3g rad/s at MaxVoltage", fastest, possible));
    }
}

void ChassisDrive::sense(Sensing& world) {
    const WheelMotion turned{turnedSince(world, m_left), turnedSince(world, m_right)};
    m_odometryPose = alongArc(m_odometryPose, chassisFromWheels(turned, m_radiusM, separation()));
    odometry.set(0, m_odometryPose.x);
    odometry.set(1, m_odometryPose.y);
    odometry.set(2, m_odometryPose.heading);
    done.set(!m_profile.busy());
    busy.set(m_profile.busy());
    if (!m_profile.busy()) finished.set(m_seen);
    publishTruth(world);
}

double ChassisDrive::turnedSince(const Services& world, std::vector<Wheel>& side) {
    double sum = 0;
    for (Wheel& wheel : side) {
        const double angle = world.jointPosition(wheel.joint);
        sum += angle - wheel.angle;
        wheel.angle = angle;
    }
    return sum / static_cast<double>(side.size());
}

std::optional<Vec3> ChassisDrive::middleOf(const Services& world, const std::vector<Wheel>& side) {
    Vec3 sum = Vec3::Zero(), anchor, axis;
    for (const Wheel& wheel : side) {
        if (!world.jointAnchor(wheel.joint, anchor, axis)) return std::nullopt;
        sum += anchor;
    }
    return Vec3(sum / static_cast<double>(side.size()));
}

/// The centre is midway between the anchors of both sides; those of the left side give the direction of +y.
void ChassisDrive::publishTruth(const Services& world) {
    const std::optional<Vec3> left = middleOf(world, m_left), right = middleOf(world, m_right);
    if (!left || !right) return;
    pose.set(0, (left->x() + right->x()) / 2);
    pose.set(1, (left->y() + right->y()) / 2);
    pose.set(2, std::atan2(right->x() - left->x(), left->y() - right->y()));
}

} // namespace trundle
