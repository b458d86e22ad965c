#include "devices/rotary_motor.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace trundle {
namespace {

constexpr double kReached = 1e-3; // of the no-load rate: a servo that is farther off its rate has no more torque

} // namespace

VoltageConstraint voltageConstraint(const MotorConstants& motor, double voltage, double lastCurrent, double h) {
    // Implicit Euler for the inductance: i = (V + L/h i_last - G w/kv) / (R + L/h), the same law with another V and R.
    const double lag = motor.inductance / h;
    const double resistance = motor.resistance + lag;
    const double drivingVoltage = voltage + lag * lastCurrent;
    const double damping = motor.torquePerAmpere() * motor.gearRatio / (resistance * motor.speedConstant);
    return {drivingVoltage * motor.speedConstant / motor.gearRatio, 1 / damping, motor.stallTorque()};
}

// The limits keep every product finite and are far beyond real motors.
void RotaryMotor::describe(Describe<RotaryMotor>& d) {
    d.help("A direct-current motor with a gear that turns a joint.");
    d.field("Joint", &RotaryMotor::m_jointName, reference("Hinge|Suspension").required(), "The joint it turns.");
    d.field("TorqueConstant", &RotaryMotor::m_torqueConstant, unitOf("N m/A").within(1e-9, 1e6).required().live(),
            "Torque per current, before the gear.");
    d.field("SpeedConstant", &RotaryMotor::m_speedConstant, unitOf("rad/s/V").within(1e-6, 1e6),
            "Speed without load per voltage: 1 / BackEmfConstant.");
    d.field("BackEmfConstant", &RotaryMotor::m_backEmfConstant, unitOf("V s/rad").within(1e-6, 1e6),
            "Voltage induced per speed: 1 / SpeedConstant.");
    d.exactlyOneOf("SpeedConstant|BackEmfConstant", "TorqueConstant"); // without losses they are equal: k_e = k_t in SI units
    d.field("Resistance", &RotaryMotor::m_resistance, ohms().within(1e-6, 1e9).required().live(), "Of the winding.");
    d.field("GearRatio", &RotaryMotor::m_gearRatio, number().within(1e-6, 1e6), "Turns of the motor per turn of the joint.");
    d.field("MaxVoltage", &RotaryMotor::m_maxVoltage, volts().within(1e-6, 1e6).required(),
            "The voltage is clipped to this; it also limits the current.");
    d.field("Inductance", &RotaryMotor::m_inductance, unitOf("H").within(0, 1e3).live(), "Of the winding: the current lags.");
    d.field("Efficiency", &RotaryMotor::m_efficiency, number().within(1e-6, 1).live(),
            "Part of the torque that passes the gear.");
    d.field("RotorInertia", &RotaryMotor::m_rotorInertia, unitOf("kg m^2").within(0, 1e3), "Of the rotor, before the gear.");
    RotaryMotorSignals::describe(d);
}

void RotaryMotor::setup(Mount& mount) {
    if (m_speedConstant.has_value() == m_backEmfConstant.has_value()) {
        mount.fail(m_speedConstant ? "SpeedConstant and BackEmfConstant say the same thing; give one of them"
                                   : "give SpeedConstant or BackEmfConstant");
        return;
    }
    m_motor = {m_torqueConstant, m_speedConstant ? *m_speedConstant : 1 / *m_backEmfConstant,
               m_resistance,     m_gearRatio,
               m_maxVoltage,     m_inductance,
               m_efficiency};
    m_joint = mount.joint(m_jointName);
    // At the joint the rotor's inertia is G^2 times as large (energy: J (G w)^2 / 2).
    if (m_rotorInertia > 0 && m_joint) mount.addAxialInertia(m_joint, m_gearRatio * m_gearRatio * m_rotorInertia);
}

/// Applies the fields that may change during a run.
void RotaryMotor::takeLiveConstants() {
    m_motor.torqueConstant = m_torqueConstant;
    m_motor.resistance = m_resistance;
    m_motor.inductance = m_inductance;
    m_motor.efficiency = m_efficiency;
}

void RotaryMotor::act(Actuation& world) {
    takeLiveConstants();
    const Supply supply = world.supply();
    const bool holds = servo.read(world) != 0;
    if (holds && supply.powered()) return actAsServo(world, supply);
    const double wanted = holds ? 0 : voltage.read(world);
    const double clipped = std::clamp(wanted, -m_motor.maxVoltage, m_motor.maxVoltage);
    m_beyond = wanted != clipped || (supply.present && std::abs(clipped) > supply.nominal);
    const double driven = supply.driven(clipped, m_motor.maxVoltage); // 0 of an empty battery: the motor brakes
    const VoltageConstraint row = voltageConstraint(m_motor, driven, current.get(), world.tick());
    world.motorRow(m_joint, row.rate, row.softness, row.limit);
}

void RotaryMotor::actAsServo(Actuation& world, const Supply& supply) {
    MotorConstants now = m_motor;
    now.maxVoltage = supply.highest(m_motor.maxVoltage);
    const double wanted = targetRate.read(world), possible = now.noLoadRate();
    m_beyond = std::abs(wanted) > possible * (1 + 1e-9);
    if (m_beyond && !m_reported) {
        m_reported = true;
        char text[200];
        std::snprintf(text, sizeof text, "it is to turn its joint at %.3g rad/s, and reaches %.3g rad/s without load at %s",
                      wanted, possible, now.maxVoltage < m_motor.maxVoltage ? "the voltage of its battery" : "MaxVoltage");
        world.warn(text);
    }
    world.servoRow(m_joint, std::clamp(wanted, -possible, possible), now.stallTorque(), now.damping());
}

void RotaryMotor::sense(Sensing& world) {
    const double effort = world.jointMotorEffort(m_joint), turning = world.jointRate(m_joint);
    const double amperes = effort / m_motor.torquePerAmpere(), change = (amperes - current.get()) / world.tick();
    terminalVoltage.set(m_motor.resistance * amperes + m_motor.inductance * change +
                        m_motor.gearRatio * turning / m_motor.speedConstant);
    torque.set(effort);
    current.set(amperes);
    rate.set(turning);
    drawPower(world);
    const bool late = servo.read(world) != 0 && std::abs(targetRate.read(world) - turning) > kReached * m_motor.noLoadRate();
    saturated.set(world.time() > 0 && (m_beyond || late));
}

/// Its driver switches the battery on for a share of the time, without losses: the battery gives this share of the winding's current. At
/// the same share, the current grows with the voltage by the square of the share over the resistance.
void RotaryMotor::drawPower(Sensing& world) {
    const Supply supply = world.supply();
    if (!supply.present || !(supply.voltage > 0)) return;
    const double share = terminalVoltage.get() / supply.voltage;
    world.draw(terminalVoltage.get() * current.get(), share * share / (m_motor.resistance + m_motor.inductance / world.tick()));
}

} // namespace trundle
