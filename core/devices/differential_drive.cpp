#include "devices/differential_drive.h"

#include <algorithm>
#include <cstdio>

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

void DifferentialDrive::describe(Describe<DifferentialDrive>& d) {
    d.help("A base with two driven wheels: turns speeds of the robot into speeds of the wheels.");
    d.field("LeftMotor", &DifferentialDrive::m_leftMotor, reference("RotaryMotor").required(),
            "Turns the left wheel; forward is positive.");
    d.field("RightMotor", &DifferentialDrive::m_rightMotor, reference("RotaryMotor").required(), "Turns the right wheel.");
    d.field("WheelRadius", &DifferentialDrive::m_radiusM, metres().within(1e-4, 1e3).required(), "Of both wheels.");
    d.field("WheelSeparation", &DifferentialDrive::m_separationM, metres().within(1e-4, 1e3).required(),
            "Between the wheels' middles.");
    d.field("Control", &DifferentialDrive::m_controlName, oneOf("servo|pi|voltage"),
            "servo: wheels hold their rate; pi: a speed controller sets the voltage; voltage: open loop.");
    d.field("Kp", &DifferentialDrive::m_kp, unitOf("V s/rad").within(0, 1e6).live(), "Of Control = pi.");
    d.field("Ki", &DifferentialDrive::m_ki, unitOf("V/rad").within(0, 1e6).live(), "Of Control = pi.");
    d.field("MaxAcceleration", &DifferentialDrive::m_maxAcceleration, metresPerSecondSquared().within(0, 1e6).live(),
            "Ramps of the speed; 0: no limit.");
    d.field("MaxAngularAcceleration", &DifferentialDrive::m_maxAngularAcceleration,
            radiansPerSecondSquared().within(0, 1e6).live(), "Ramps of the turn rate; 0: no limit.");
    DifferentialDriveSignals::describe(d);
}

void DifferentialDrive::setup(Mount& mount) {
    m_control = m_controlName == "pi" ? Control::Pi : m_controlName == "voltage" ? Control::Voltage : Control::Servo;
    if (m_leftMotor == m_rightMotor) return mount.fail("LeftMotor and RightMotor are the same motor");
    m_left = mountWheel(mount, m_leftMotor);
    m_right = mountWheel(mount, m_rightMotor);
}

DifferentialDrive::Wheel DifferentialDrive::mountWheel(Mount& mount, const std::string& motor) {
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

void DifferentialDrive::readCommands(const Services& world) {
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

void DifferentialDrive::act(Actuation& world) {
    readCommands(world);
    const ChassisMotion velocity = m_profile.next(limits(), world.tick());
    const WheelMotion rates = wheelsFromChassis(velocity, m_radiusM, m_separationM);
    warnOfSpeeds(world, velocity, rates);
    drive(world, m_left, rates.left);
    drive(world, m_right, rates.right);
}

void DifferentialDrive::drive(Actuation& world, Wheel& wheel, double rate) {
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
double DifferentialDrive::piVoltage(const Services& world, Wheel& wheel, double rate) const {
    const double error = wheel.lastTarget - world.jointRate(wheel.joint);
    const double angle = wheel.errorAngle + error * world.tick();
    const double voltage = rate * wheel.voltsPerRate + m_kp * error + m_ki * angle;
    const double clipped = std::clamp(voltage, -wheel.maxVoltage, wheel.maxVoltage);
    const bool windingUp = voltage != clipped && (voltage > clipped) == (error > 0);
    if (!windingUp) wheel.errorAngle = angle;
    return voltage;
}

void DifferentialDrive::warnOfSpeeds(const Services& world, const ChassisMotion& velocity, const WheelMotion& rates) {
    if (!m_reportedTurnRate && std::abs(velocity.angular) * world.tick() > kMaxTurnPerTick) {
        m_reportedTurnRate = true;
        world.warn(formatted("turning at %.3g rad/s is too fast for a tick of %.3g s: heading gets inexact above %.3g rad/s",
                             velocity.angular, world.tick().value, kMaxTurnPerTick / world.tick()));
    }
    const double fastest = std::max(std::abs(rates.left), std::abs(rates.right));
    const double possible = std::min(m_left.maxVoltage / m_left.voltsPerRate, m_right.maxVoltage / m_right.voltsPerRate);
    if (m_control != Control::Servo && !m_reportedSpeed && fastest > possible) { // a servo reports that itself
        m_reportedSpeed = true;
        world.warn(formatted("a wheel is to turn at %.3g rad/s, its motor reaches %.3g rad/s at MaxVoltage", fastest, possible));
    }
}

void DifferentialDrive::sense(Sensing& world) {
    const double left = world.jointPosition(m_left.joint), right = world.jointPosition(m_right.joint);
    const WheelMotion turned{left - m_left.angle, right - m_right.angle};
    m_left.angle = left;
    m_right.angle = right;
    m_odometryPose = alongArc(m_odometryPose, chassisFromWheels(turned, m_radiusM, m_separationM));
    odometry.set(0, m_odometryPose.x);
    odometry.set(1, m_odometryPose.y);
    odometry.set(2, m_odometryPose.heading);
    done.set(!m_profile.busy());
    busy.set(m_profile.busy());
    if (!m_profile.busy()) finished.set(m_seen);
    publishTruth(world);
}

/// The axle's centre is midway between the two anchors; the left anchor gives the direction of +y.
void DifferentialDrive::publishTruth(const Services& world) {
    Vec3 left, right, axis;
    if (!world.jointAnchor(m_left.joint, left, axis) || !world.jointAnchor(m_right.joint, right, axis)) return;
    pose.set(0, (left.x() + right.x()) / 2);
    pose.set(1, (left.y() + right.y()) / 2);
    pose.set(2, std::atan2(right.x() - left.x(), left.y() - right.y()));
}

} // namespace trundle
