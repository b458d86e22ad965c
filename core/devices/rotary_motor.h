#pragma once
#include <optional>

#include <trundle/device.h>
#include <trundle/device_signals.h>

#include "devices/gear_play.h"
#include "devices/motor_driver.h"
#include "devices/motor_losses.h"
#include "devices/winding_heat.h"

namespace trundle {

/// A DC motor with a gear, SI units.
struct MotorConstants {
    double torqueConstant = 0; ///< kt, N m/A
    double speedConstant = 0;  ///< kv, rad/s per V; back-EMF constant = 1/kv
    double resistance = 0;     ///< ohm
    double gearRatio = 1;
    double maxVoltage = 0;
    double inductance = 0; ///< H
    double efficiency = 1;

    /// N m at the joint per ampere.
    [[nodiscard]] double torquePerAmpere() const { return efficiency * gearRatio * torqueConstant; }
    /// N m s/rad at the joint: how fast the torque falls with its rate.
    [[nodiscard]] double damping() const { return torquePerAmpere() * gearRatio / (resistance * speedConstant); }
    /// The joint's rate without load at the highest voltage, rad/s.
    [[nodiscard]] double noLoadRate() const { return maxVoltage * speedConstant / gearRatio; }
    /// The torque at the joint at the driver's current limit, which is the stall torque at the highest voltage.
    [[nodiscard]] double stallTorque() const { return torquePerAmpere() * maxVoltage / resistance; }
    /// Ohm, that the inductance adds to the resistance over a tick of h seconds: voltageConstraint().
    [[nodiscard]] double lag(double h) const;
    /// The same motor whose gear lets this part of its torque pass.
    [[nodiscard]] MotorConstants withEfficiency(double part) const {
        MotorConstants other = *this;
        other.efficiency = part;
        return other;
    }
};

/// The joint's motor constraint: torque = (rate - w) / softness within the limit.
struct VoltageConstraint {
    double rate = 0, softness = 0, limit = 0;
};

/// T = G kt (V - G w / kv) / R (thesis eq. 3.1) with w the rate after the step. The inductance is a first-order lag of the current,
/// L di/dt = V - R i - G w / kv, solved exactly over the tick at the rate after the step, so that it is stable at any tick length.
[[nodiscard]] VoltageConstraint voltageConstraint(const MotorConstants& motor, double voltage, double lastCurrent, double h);

/// Drives a joint with a voltage, or as a servo with a target rate. The only owner of the joint's motor constraint.
class RotaryMotor final : public Device, public RotaryMotorSignals {
public:
    static void describe(Describe<RotaryMotor>& d);
    /// Fails unless exactly one of SpeedConstant and BackEmfConstant is given.
    void setup(Mount& mount) override;
    void act(Actuation& world) override;
    void sense(Sensing& world) override;

private:
    static void describeHeat(Describe<RotaryMotor>& d);
    void takeLiveConstants();
    void actByVoltage(Actuation& world, const Supply& supply, double wanted);
    void actAsServo(Actuation& world, const Supply& supply);
    /// Lets the motor turn on its own, if what it does now does not reach the joint. `wanted`: its constraint with an ideal gear.
    bool actInPlay(Actuation& world, bool reaches, const GearPlay::Free& wanted);
    void limitCurrent(JointDrive& drive, double turning) const;
    void setLosses(double torque, double rate);
    void apply(Actuation& world, const JointDrive& drive);
    [[nodiscard]] double torqueLimit() const;
    [[nodiscard]] bool isLimited() const;
    void drawPower(Sensing& world);

    std::string m_jointName;
    MotorConstants m_motor;
    MotorLosses m_losses;
    MotorDriver m_driver;
    ThermalConstants m_thermal;
    double m_torqueConstant = 0, m_resistance = 0, m_gearRatio = 1, m_maxVoltage = 0, m_inductance = 0, m_efficiency = 1,
           m_rotorInertia = 0, m_frictionTorque = 0, m_viscousFriction = 0;
    double m_windingResistance = 0, m_housingResistance = 0, m_windingTime = 10, m_housingTime = 600, m_ambient = 25;
    std::optional<double> m_highestTemperature;
    std::optional<double> m_backdrivingEfficiency, m_currentLimit;
    double m_deadBand = 0, m_backlash = 0;
    int m_pwmSteps = 0;
    std::optional<double> m_speedConstant, m_backEmfConstant;

    JointId m_joint;
    MotorConstants m_now; ///< in this tick, with the losses at its state
    LossLine m_line;
    WindingHeat m_heat;
    GearPlay m_play;
    double m_freeTorque = 0; ///< N m at the joint with an ideal gear, of the motor while it turns within the play
    double m_momentum = 0;   ///< N m s, that it brings to the joint where the play ends
    bool m_beyond = false;   ///< the command, MaxVoltage
    bool m_reported = false, m_reportedVoltage = false; ///< a rate beyond reach; a voltage without effect
};

} // namespace trundle
