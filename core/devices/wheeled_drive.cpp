#include "devices/wheeled_drive.h"

#include <algorithm>
#include <cmath>
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

ChassisMotion Drive::follow(Actuation& world, const ChassisMotion& velocity, const ChassisMotion& amount, double sequence) {
    const bool isNew = sequence != m_seen;
    m_seen = sequence;
    if (amount.linear == 0 && amount.lateral == 0 && amount.angular == 0) {
        m_profile.aim(velocity);
    } else if (isNew) {
        const std::string why = m_profile.start(velocity, amount, limits()).value_or("");
        if (!why.empty() && why != m_refused) world.warn("command refused: " + why); // not in each tick
        m_refused = why;
    }
    return m_profile.next(limits(), world.tick());
}

double WheeledDrive::Wheel::turnedSince(const Services& world) {
    const double now = world.jointPosition(joint), turned = now - angle;
    angle = now;
    return turned;
}

double WheeledDrive::Wheel::slip(const Services& world, double radius) {
    Vec3 now, axis;
    if (!world.jointAnchor(joint, now, axis)) return 0;
    const bool known = isPlaced && world.time() > 0;
    const Vec3 moved = known ? Vec3(now - anchor) : Vec3(Vec3::Zero());
    const Vec3 rolls = axis.cross(Vec3::UnitZ());
    anchor = now;
    isPlaced = true;
    const double length = rolls.norm();
    return known && length > 0 ? radius * world.jointRate(joint) - moved.dot(rolls) / length / world.tick() : 0;
}

void WheeledDrive::mountWheels(Mount& mount, const std::vector<std::string>& motors) {
    std::vector<std::string> sorted = motors;
    std::sort(sorted.begin(), sorted.end());
    if (const auto twice = std::adjacent_find(sorted.begin(), sorted.end()); twice != sorted.end())
        return mount.fail("the motor " + *twice + " is given twice");
    m_control = m_controlName == "pi" ? Control::Pi : m_controlName == "voltage" ? Control::Voltage : Control::Servo;
    for (const std::string& motor : motors) m_wheels.push_back(mountWheel(mount, motor));
}

WheeledDrive::Wheel WheeledDrive::mountWheel(Mount& mount, const std::string& motor) {
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

void WheeledDrive::drive(Actuation& world, Wheel& wheel, double rate) {
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
double WheeledDrive::piVoltage(const Services& world, Wheel& wheel, double rate) const {
    const double error = wheel.lastTarget - world.jointRate(wheel.joint);
    const double angle = wheel.errorAngle + error * world.tick();
    const double voltage = rate * wheel.voltsPerRate + m_kp * error + m_ki * angle;
    const double clipped = std::clamp(voltage, -wheel.maxVoltage, wheel.maxVoltage);
    const bool windingUp = voltage != clipped && (voltage > clipped) == (error > 0);
    if (!windingUp) wheel.errorAngle = angle;
    return voltage;
}

void WheeledDrive::warnOfSpeeds(const Services& world, double angular, double fastest) {
    if (!m_reportedTurnRate && std::abs(angular) * world.tick() > kMaxTurnPerTick) {
        m_reportedTurnRate = true;
        world.warn(formatted("turning at %.3g rad/s is too fast for a tick of %.3g s: heading gets inexact above %.3g rad/s",
                             angular, world.tick().value, kMaxTurnPerTick / world.tick()));
    }
    if (m_control == Control::Servo || m_reportedSpeed) return; // a servo reports that itself
    double possible = std::numeric_limits<double>::infinity();
    for (const Wheel& wheel : m_wheels) possible = std::min(possible, wheel.maxVoltage / wheel.voltsPerRate);
    if (fastest > possible) {
        m_reportedSpeed = true;
        world.warn(formatted("a wheel is to turn at %.3g rad/s, its motor reaches %.3g rad/s at MaxVoltage", fastest, possible));
    }
}

} // namespace trundle
