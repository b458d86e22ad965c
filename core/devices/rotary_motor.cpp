#include "devices/rotary_motor.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace trundle {
namespace {

constexpr double kStiff = 1e-6;   // of a motor's softness: a servo that turns freely
constexpr double kReached = 1e-3; // of the no-load rate: a servo that is farther off its rate has no more torque

} // namespace

double MotorConstants::lag(double h) const { return inductance > 0 ? resistance / std::expm1(h * resistance / inductance) : 0; }

VoltageConstraint voltageConstraint(const MotorConstants& motor, double voltage, double lastCurrent, double h) {
    // The current of a coil whose voltage and rate are those of the whole tick: i = a i_last + (1 - a) (V - G w/kv) / R with
    // a = exp(-h R/L), which is the same law with another V and R.
    const double lag = motor.lag(h);
    const double resistance = motor.resistance + lag;
    const double drivingVoltage = voltage + lag * lastCurrent;
    const double damping = motor.torquePerAmpere() * motor.gearRatio / (resistance * motor.speedConstant);
    return {drivingVoltage * motor.speedConstant / motor.gearRatio, 1 / damping, motor.stallTorque()};
}

// The limits keep every product finite and are far beyond real motors.
void RotaryMotor::describe(Describe<RotaryMotor>& d) {
    d.help("A direct-current motor with a gear that turns a joint.").independent();
    d.field("Joint", &RotaryMotor::m_jointName, reference("Hinge|Suspension").required(), "The joint it turns.");
    d.field("TorqueConstant", &RotaryMotor::m_torqueConstant, unitOf("Nm/A").within(1e-9, 1e6).required().live(),
            "Torque per current, before the gear.");
    d.field("SpeedConstant", &RotaryMotor::m_speedConstant, unitOf("rad/s/V").within(1e-6, 1e6),
            "Speed without load per voltage: 1 / BackEmfConstant.");
    d.field("BackEmfConstant", &RotaryMotor::m_backEmfConstant, unitOf("Vs/rad").within(1e-6, 1e6),
            "Voltage induced per speed: 1 / SpeedConstant.");
    d.exactlyOneOf("SpeedConstant|BackEmfConstant", "TorqueConstant"); // without losses they are equal: k_e = k_t in SI units
    d.field("Resistance", &RotaryMotor::m_resistance, ohms().within(1e-6, 1e9).required().live(), "Of the winding.");
    d.field("GearRatio", &RotaryMotor::m_gearRatio, number().within(1e-6, 1e6), "Turns of the motor per turn of the joint.");
    d.field("MaxVoltage", &RotaryMotor::m_maxVoltage, volts().within(1e-6, 1e6).required(),
            "The voltage is clipped to this; it also limits the current.");
    d.field("Inductance", &RotaryMotor::m_inductance, unitOf("H").within(0, 1e3).live(), "Of the winding: the current lags.");
    d.field("Efficiency", &RotaryMotor::m_efficiency, number().within(1e-6, 1).live(),
            "Part of the torque that passes the gear.");
    d.field("BackdrivingEfficiency", &RotaryMotor::m_backdrivingEfficiency, number().within(1e-3, 1).live(),
            "Part of the joint's torque that passes the gear backwards, to the motor; not given: the torque of a motor that "
            "brakes is "
            "lowered by Efficiency too.");
    d.field("FrictionTorque", &RotaryMotor::m_frictionTorque, newtonMetres().within(0, 1e6).live(),
            "Dry friction of the rotor, before the gear: TorqueConstant times the current without load, less ViscousFriction.");
    d.field("ViscousFriction", &RotaryMotor::m_viscousFriction, unitOf("Nms/rad").within(0, 1e6).live(),
            "Friction of the rotor per speed, before the gear.");
    d.field("CurrentLimit", &RotaryMotor::m_currentLimit, amperes().above(0).atMost(1e6).live(),
            "Of the driver; not given: MaxVoltage / Resistance.");
    d.field("DeadBand", &RotaryMotor::m_deadBand, volts().within(0, 1e6).live(),
            "Commanded voltages below this give none, as a driver does whose transistors need time to switch.");
    Quantity steps = number().within(0, 1e9);
    steps.type = TRUNDLE_INTEGER;
    d.field("PwmSteps", &RotaryMotor::m_pwmSteps, steps,
            "Steps of the driver's duty cycle from 0 to full, 255 for 8 bits; 0: continuous.");
    d.field("Backlash", &RotaryMotor::m_backlash, degrees().within(0, 90),
            "Play of the gear, at the joint: on its way from one flank to the other the motor moves nothing.");
    d.field("RotorInertia", &RotaryMotor::m_rotorInertia, unitOf("kgm^2").within(0, 1e3),
            "Of the rotor, before the gear, about the axis of the joint.");
    describeHeat(d);
    RotaryMotorSignals::describe(d);
}

void RotaryMotor::describeHeat(Describe<RotaryMotor>& d) {
    d.field(
        "ThermalResistanceWinding", &RotaryMotor::m_windingResistance, unitOf("K/W").within(0, 1e6),
        "Winding to housing; with ThermalResistanceHousing, the winding heats up, and its Resistance, given at 25 degC, rises.");
    d.field("ThermalResistanceHousing", &RotaryMotor::m_housingResistance, unitOf("K/W").within(0, 1e6), "Housing to air.");
    d.field("ThermalTimeConstantWinding", &RotaryMotor::m_windingTime, seconds().within(1e-3, 1e9),
            "Of the winding in its housing.");
    d.field("ThermalTimeConstantHousing", &RotaryMotor::m_housingTime, seconds().within(1e-3, 1e9), "Of the motor in the air.");
    d.field("AmbientTemperature", &RotaryMotor::m_ambient, unitOf("degC").within(-273, 1e4),
            "Of the air, and of the motor at the start.");
    d.field("MaxTemperature", &RotaryMotor::m_highestTemperature, unitOf("degC").within(-273, 1e4),
            "Of the winding: its driver lowers the current over the 10 K below it to nothing; not given: it does not.");
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
    m_now = m_motor;
    if ((m_windingResistance > 0) != (m_housingResistance > 0))
        mount.fail("ThermalResistanceWinding and ThermalResistanceHousing are given together or not at all");
    m_thermal = {m_windingResistance, m_housingResistance, m_windingTime, m_housingTime, m_ambient, m_highestTemperature};
    m_heat.start(m_ambient);
    m_play.start(m_backlash);
    m_joint = mount.joint(m_jointName);
    if (m_rotorInertia > 0 && m_joint) mount.addRotor(m_joint, m_rotorInertia, m_gearRatio);
}

/// Applies the fields that may change during a run.
void RotaryMotor::takeLiveConstants() {
    m_motor.torqueConstant = m_torqueConstant;
    m_motor.resistance = m_resistance;
    m_motor.inductance = m_inductance;
    m_motor.efficiency = m_efficiency;
    m_losses = {m_gearRatio * m_frictionTorque, m_gearRatio * m_gearRatio * m_viscousFriction, m_efficiency,
                m_backdrivingEfficiency.value_or(0)};
    m_driver = {m_currentLimit, m_deadBand, m_pwmSteps};
    if (!m_thermal.any()) return;
    m_motor.resistance *= m_heat.resistanceFactor();
    if (const double share = m_heat.currentShare(m_thermal); share < 1)
        m_driver.currentLimit = share * std::min(m_currentLimit.value_or(HUGE_VAL), m_motor.maxVoltage / m_motor.resistance);
}

void RotaryMotor::act(Actuation& world) {
    takeLiveConstants();
    const Supply supply = world.supply();
    const bool holds = servo.read(world) != 0;
    if (holds && !m_reportedVoltage && voltage.read(world) != 0) {
        m_reportedVoltage = true;
        world.warn("its voltage has no effect while servo is set, as a drive that has this motor does in each tick; command the drive instead");
    }
    if (holds && supply.powered()) return actAsServo(world, supply);
    actByVoltage(world, supply, holds ? 0 : voltage.read(world));
}

void RotaryMotor::actByVoltage(Actuation& world, const Supply& supply, double wanted) {
    const double clipped = std::clamp(wanted, -m_motor.maxVoltage, m_motor.maxVoltage);
    m_beyond = wanted != clipped || (supply.present && std::abs(clipped) > supply.nominal);
    const double switched = m_driver.voltageOf(clipped, supply.present ? supply.nominal : m_motor.maxVoltage);
    const double driven = supply.driven(switched, m_motor.maxVoltage); // 0 of an empty battery: the motor brakes
    if (m_losses.any() || m_play.exists()) {
        const VoltageConstraint ideal = voltageConstraint(m_motor.withEfficiency(1), driven, current.get(), world.tick());
        const double turning = world.jointRate(m_joint), limit = torqueLimit() / m_now.efficiency;
        const double driving = std::clamp((ideal.rate - turning) / ideal.softness, -limit, limit);
        if (actInPlay(world, m_play.reaches(driving), {ideal.rate, ideal.softness, limit})) return;
        setLosses(driving, turning);
    } else setLosses(0, 0);
    const VoltageConstraint row = voltageConstraint(m_now, driven, current.get(), world.tick());
    apply(world, {row.rate, row.softness, torqueLimit()});
}

void RotaryMotor::actAsServo(Actuation& world, const Supply& supply) {
    if (m_losses.any()) setLosses(m_motor.withEfficiency(1).torquePerAmpere() * current.get(), world.jointRate(m_joint));
    else setLosses(0, 0);
    MotorConstants now = m_now;
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
    JointDrive drive{std::clamp(wanted, -possible, possible), 0, now.stallTorque(), now.damping()};
    if (m_play.exists()) {
        const double error = drive.rate - world.jointRate(m_joint), slack = kReached * m_motor.noLoadRate();
        const bool reaches = m_play.reaches(error, slack, world.jointMotorEffort(m_joint));
        if (actInPlay(world, reaches, {drive.rate, kStiff / drive.damping, drive.limit})) return;
    }
    if (m_driver.currentLimit) limitCurrent(drive, world.jointRate(m_joint));
    apply(world, drive);
}

/// Either the voltage or the driver's current is the limit at this rate.
void RotaryMotor::limitCurrent(JointDrive& drive, double turning) const {
    const double most = torqueLimit();
    if (!(most < drive.limit)) return;
    const double reserve = drive.limit - drive.damping * std::abs(turning);
    drive.limit = most;
    drive.damping = reserve < most ? (most - reserve) / std::abs(turning) : 0;
}

bool RotaryMotor::actInPlay(Actuation& world, bool reaches, const GearPlay::Free& wanted) {
    if (m_momentum != 0) world.jointTorque(m_joint, m_momentum / world.tick());
    m_momentum = 0;
    if (reaches) return false;
    GearPlay::Free free = wanted;
    free.inertia = m_gearRatio * m_gearRatio * m_rotorInertia;
    free.dryFriction = m_losses.dry;
    free.viscousFriction = m_losses.viscous;
    m_freeTorque = m_play.turn(free, world.jointRate(m_joint), world.tick());
    m_line = {m_motor.efficiency};
    world.motorRow(m_joint, 0, 1, 0);
    return true;
}

/// `torque`: of the motor with an ideal gear, at the joint.
void RotaryMotor::setLosses(double torque, double rate) {
    m_line = m_losses.any() ? lossLine(m_losses, torque, rate) : LossLine{m_motor.efficiency};
    m_now = m_motor.withEfficiency(m_line.factor);
}

/// Its highest torque at the joint, by its current.
double RotaryMotor::torqueLimit() const {
    return m_driver.currentLimit ? m_now.torquePerAmpere() * *m_driver.currentLimit : m_now.stallTorque();
}

void RotaryMotor::apply(Actuation& world, const JointDrive& drive) {
    if (!m_losses.any()) {
        if (drive.damping > 0) world.servoRow(m_joint, drive.rate, drive.limit, drive.damping);
        else world.motorRow(m_joint, drive.rate, drive.softness, drive.limit);
        return;
    }
    JointDrive whole = drive;
    whole.dryFriction = m_line.dry;
    whole.viscousFriction = m_line.viscous;
    world.driveJoint(m_joint, whole);
    if (m_line.offset != 0) world.jointTorque(m_joint, m_line.offset);
}

bool RotaryMotor::isLimited() const {
    return m_driver.currentLimit && std::abs(current.get()) > *m_driver.currentLimit * (1 - 1e-9);
}

void RotaryMotor::sense(Sensing& world) {
    const double effort = world.jointMotorEffort(m_joint), turning = world.jointRate(m_joint);
    const bool isFree = m_play.isFree();
    const double amperes = isFree ? m_freeTorque / m_motor.withEfficiency(1).torquePerAmpere() : effort / m_now.torquePerAmpere();
    const double lagging = m_motor.lag(world.tick()) * (amperes - current.get()), ownRate = isFree ? m_play.rate() : turning;
    terminalVoltage.set(m_motor.resistance * amperes + lagging + m_motor.gearRatio * ownRate / m_motor.speedConstant);
    m_momentum = m_play.follow(turning, world.tick());
    torque.set(m_losses.any() && !isFree ? effort + m_line.offset + world.jointFrictionEffort(m_joint) : effort);
    current.set(amperes);
    rate.set(turning);
    drawPower(world);
    if (m_thermal.any() && world.time() > 0) m_heat.heat(m_thermal, m_motor.resistance * amperes * amperes, world.tick());
    temperature.set(m_heat.winding());
    const bool late = servo.read(world) != 0 && std::abs(targetRate.read(world) - turning) > kReached * m_motor.noLoadRate();
    saturated.set(world.time() > 0 && (m_beyond || late || isLimited()));
}

/// Its driver switches the battery on for a share of the time, without losses: the battery gives this share of the winding's current. At
/// the same share, the current grows with the voltage by the square of the share over the resistance.
void RotaryMotor::drawPower(Sensing& world) {
    const Supply supply = world.supply();
    if (!supply.present || !(supply.voltage > 0)) return;
    const double share = terminalVoltage.get() / supply.voltage;
    world.draw(terminalVoltage.get() * current.get(), share * share / (m_motor.resistance + m_motor.lag(world.tick())));
}

} // namespace trundle
