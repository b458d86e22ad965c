#pragma once
#include <trundle/device.h>
#include <trundle/device_signals.h>

#include "devices/drive_profile.h"
#include "devices/kinematics.h"

namespace trundle {

/// Converts chassis motion into wheel speeds for a two-wheeled base (thesis eqs. 3.4-3.7) and commands its two motors. Belongs to
/// a robot; commands are read once per tick in act, before the motors act. Odometry uses only the joint angles.
class DifferentialDrive final : public Device, public DifferentialDriveSignals {
public:
    static void describe(Describe<DifferentialDrive>& d);
    /// Binds both motors. If one is missing, fails with a list of the available names.
    void setup(Mount& mount) override;
    void act(Actuation& world) override;
    void sense(Sensing& world) override;

private:
    enum class Control { Servo, Pi, Voltage };
    /// One motor and its joint.
    struct Wheel {
        JointId joint;
        Port<RotaryMotorSignals> motor;
        double voltsPerRate = 0; ///< back-EMF at the joint, V s/rad
        double maxVoltage = 0;
        double lastTarget = 0; ///< rad/s
        double errorAngle = 0; ///< rad, integral of the rate error
        double angle = 0;      ///< rad, at the last sense
    };
    [[nodiscard]] Wheel mountWheel(Mount& mount, const std::string& motor);
    void readCommands(const Services& world);
    void drive(Actuation& world, Wheel& wheel, double rate);
    [[nodiscard]] double piVoltage(const Services& world, Wheel& wheel, double rate) const;
    void warnOfSpeeds(const Services& world, const ChassisMotion& velocity, const WheelMotion& rates);
    void publishTruth(const Services& world);
    [[nodiscard]] DriveLimits limits() const { return {m_maxAcceleration, m_maxAngularAcceleration}; }

    std::string m_leftMotor, m_rightMotor, m_controlName = "servo";
    double m_radiusM = 0, m_separationM = 0;
    double m_kp = 0.5, m_ki = 10; ///< V s/rad, V/rad
    double m_maxAcceleration = 1, m_maxAngularAcceleration = 4;

    Control m_control = Control::Servo;
    Wheel m_left, m_right;
    DriveProfile m_profile;
    double m_seen = 0; ///< sequence number of the last amount started or refused
    PlanePose m_odometryPose;
    bool m_reportedTurnRate = false, m_reportedSpeed = false;
};

} // namespace trundle
