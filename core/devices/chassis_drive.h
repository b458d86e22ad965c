#pragma once
#include <optional>

#include <trundle/device.h>
#include <trundle/device_signals.h>

#include "devices/drive_profile.h"
#include "devices/kinematics.h"

namespace trundle {

/// Converts chassis motion into wheel speeds for a base with driven wheels on both sides (thesis eqs. 3.4-3.7) and commands its motors.
/// Belongs to a robot; commands are read once per tick in act, before the motors act. Odometry uses only the joint angles, of each
/// side on average.
class ChassisDrive : public Device, public DifferentialDriveSignals {
public:
    void act(Actuation& world) override;
    void sense(Sensing& world) override;

protected:
    /// Describes all but the motors.
    template <class T> static void describeDrive(Describe<T>& d) {
        d.field("WheelRadius", &ChassisDrive::m_radiusM, metres().within(1e-4, 1e3).required(), "Of its wheels.");
        d.field("WheelSeparation", &ChassisDrive::m_separationM, metres().within(1e-4, 1e3).required(),
                "Between the wheels' middles.");
        d.field("Control", &ChassisDrive::m_controlName, oneOf("servo|pi|voltage"),
                "servo: wheels hold their rate; pi: a speed controller sets the voltage; voltage: open loop.");
        d.field("Kp", &ChassisDrive::m_kp, unitOf("V s/rad").within(0, 1e6).live(), "Of Control = pi.");
        d.field("Ki", &ChassisDrive::m_ki, unitOf("V/rad").within(0, 1e6).live(), "Of Control = pi.");
        d.field("MaxAcceleration", &ChassisDrive::m_maxAcceleration, metresPerSecondSquared().within(0, 1e6).live(),
                "Ramps of the speed; 0: no limit.");
        d.field("MaxAngularAcceleration", &ChassisDrive::m_maxAngularAcceleration,
                radiansPerSecondSquared().within(0, 1e6).live(), "Ramps of the turn rate; 0: no limit.");
    }
    /// Binds the motors of both sides, at least one each. If one is missing, fails with a list of the available names.
    void mountWheels(Mount& mount, const std::vector<std::string>& left, const std::vector<std::string>& right);

    double m_skidFactor = 1;

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
    [[nodiscard]] double separation() const { return m_separationM * m_skidFactor; }
    [[nodiscard]] Wheel mountWheel(Mount& mount, const std::string& motor);
    void readCommands(const Services& world);
    void drive(Actuation& world, Wheel& wheel, double rate);
    [[nodiscard]] double piVoltage(const Services& world, Wheel& wheel, double rate) const;
    void warnOfSpeeds(const Services& world, const ChassisMotion& velocity, const WheelMotion& rates);
    void publishTruth(const Services& world);
    /// rad, the mean of the wheels of one side since the last call.
    [[nodiscard]] static double turnedSince(const Services& world, std::vector<Wheel>& side);
    [[nodiscard]] static std::optional<Vec3> middleOf(const Services& world, const std::vector<Wheel>& side);
    [[nodiscard]] DriveLimits limits() const { return {m_maxAcceleration, m_maxAngularAcceleration}; }

    std::string m_controlName = "servo";
    double m_radiusM = 0, m_separationM = 0;
    double m_kp = 0.5, m_ki = 10; ///< V s/rad, V/rad
    double m_maxAcceleration = 1, m_maxAngularAcceleration = 4;

    Control m_control = Control::Servo;
    std::vector<Wheel> m_left, m_right;
    DriveProfile m_profile;
    double m_seen = 0; ///< sequence number of the last amount started or refused
    PlanePose m_odometryPose;
    bool m_reportedTurnRate = false, m_reportedSpeed = false;
};

} // namespace trundle
