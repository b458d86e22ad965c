#pragma once
#include <optional>
#include <string>
#include <vector>

#include <trundle/device.h>
#include <trundle/device_signals.h>

#include "devices/drive_profile.h"
#include "devices/kinematics.h"

namespace trundle {

/// What all drives share: commands as velocities or amounts. Belongs to a robot; commands are read once per tick in act, before what it
/// drives acts.
class Drive : public Device {
protected:
    template <class T> static void describeAcceleration(Describe<T>& d) {
        d.field("MaxAcceleration", &Drive::m_maxAcceleration, metresPerSecondSquared().within(0, 1e6).live(),
                "Ramps of the speed; 0: no limit.");
    }
    /// Of drives with a turn rate as command.
    template <class T> static void describeTurning(Describe<T>& d) {
        d.field("MaxAngularAcceleration", &Drive::m_maxAngularAcceleration, radiansPerSecondSquared().within(0, 1e6).live(),
                "Ramps of the turn rate; 0: no limit.");
    }

    /// Follows the velocity or, with a new sequence number, starts the amount; returns the mean velocity over this tick.
    ChassisMotion follow(Actuation& world, const ChassisMotion& velocity, const ChassisMotion& amount, double sequence);

    template <class S> void publishState(S& signals, const PlanePose& odometry) const {
        signals.odometry.set(0, odometry.x);
        signals.odometry.set(1, odometry.y);
        signals.odometry.set(2, odometry.heading);
        signals.done.set(!m_profile.busy());
        signals.busy.set(m_profile.busy());
        if (!m_profile.busy()) signals.finished.set(m_seen);
    }
    template <class S> static void publishPose(S& signals, const std::optional<PlanePose>& pose) {
        if (!pose) return;
        signals.pose.set(0, pose->x);
        signals.pose.set(1, pose->y);
        signals.pose.set(2, pose->heading);
    }

private:
    [[nodiscard]] DriveLimits limits() const { return {m_maxAcceleration, m_maxAngularAcceleration}; }

    double m_maxAcceleration = 1, m_maxAngularAcceleration = 4;
    DriveProfile m_profile;
    double m_seen = 0;     ///< sequence number of the last amount started or refused
    std::string m_refused; ///< why, of the last one
};

/// What drives on wheels share: driven wheels and the control of their motors.
class WheeledDrive : public Drive {
protected:
    /// One motor and its joint.
    struct Wheel {
        JointId joint;
        Port<RotaryMotorSignals> motor;
        double voltsPerRate = 0; ///< back-EMF at the joint, V s/rad
        double maxVoltage = 0;
        double lastTarget = 0; ///< rad/s
        double errorAngle = 0; ///< rad, integral of the rate error
        double angle = 0;      ///< rad, at the last sense

        Vec3 anchor = Vec3::Zero(); ///< of the joint in the world, at the last sense
        bool isPlaced = false;      ///< whether that is known

        double turnedSince(const Services& world); ///< rad, since the last call
        /// m/s by which it rolls faster over level ground than its axle moves, in this tick; to be called once in each.
        double slip(const Services& world, double radius);
    };

    template <class T> static void describeRadius(Describe<T>& d) {
        d.field("WheelRadius", &WheeledDrive::m_radiusM, metres().within(1e-4, 1e3).required(), "Of its wheels.");
    }
    template <class T> static void describeControl(Describe<T>& d) {
        d.field("Control", &WheeledDrive::m_controlName, oneOf("servo|pi|voltage"),
                "servo: wheels hold their rate; pi: a speed controller sets the voltage; voltage: open loop.");
        d.field("Kp", &WheeledDrive::m_kp, unitOf("Vs/rad").within(0, 1e6).live(), "Of Control = pi.");
        d.field("Ki", &WheeledDrive::m_ki, unitOf("V/rad").within(0, 1e6).live(), "Of Control = pi.");
        describeAcceleration(d);
    }

    /// Binds the motors in their order. If one is missing, or given twice, fails with a message.
    void mountWheels(Mount& mount, const std::vector<std::string>& motors);
    [[nodiscard]] std::vector<Wheel>& wheels() { return m_wheels; }
    [[nodiscard]] double radius() const { return m_radiusM; }

    void drive(Actuation& world, Wheel& wheel, double rate);
    /// Reports once each what is too fast for the tick or the motors: the turn rate, and the rate of the fastest wheel (rad/s).
    void warnOfSpeeds(const Services& world, double angular, double fastest);

private:
    enum class Control { Servo, Pi, Voltage };
    [[nodiscard]] static Wheel mountWheel(Mount& mount, const std::string& motor);
    [[nodiscard]] double piVoltage(const Services& world, Wheel& wheel, double rate) const;

    std::string m_controlName = "servo";
    double m_radiusM = 0;
    double m_kp = 0.5, m_ki = 10; ///< V s/rad, V/rad

    Control m_control = Control::Servo;
    std::vector<Wheel> m_wheels;
    bool m_reportedTurnRate = false, m_reportedSpeed = false;
};

} // namespace trundle
