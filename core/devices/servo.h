#pragma once
#include <trundle/device.h>
#include <trundle/device_signals.h>

#include "devices/gear_play.h"

namespace trundle {

/// Moves a joint to a position, or keeps it at a rate, by a controller of its own. As a motor with a gear, its torque or force falls from
/// the highest at rest to nothing at MaxSpeed; against the motion it brakes with the highest. The only owner of the joint's motor
/// constraint.
class JointServo : public Device {
public:
    void setup(Mount& mount) final;
    void act(Actuation& world) final;
    void sense(Sensing& world) final;

protected:
    virtual double wanted(Services& world) = 0; ///< rad, m, rad/s or m/s
    virtual void publish(double position, double rate, double effort, bool saturated) = 0;

    std::string m_jointName, m_mode = "position";
    double m_maxEffort = 0, m_maxSpeed = 0; ///< N m or N; rad/s or m/s
    double m_timeConstant = 0.05;           ///< s
    double m_backlash = 0;                  ///< rad or m

private:
    [[nodiscard]] static double shareOf(const Supply& supply);
    void drawPower(Sensing& world, double rate, double effort) const;

    JointId m_joint;
    double m_target = 0, m_rate = 0; ///< of this tick
    GearPlay m_play;
};

class Servo final : public JointServo, public ServoSignals {
public:
    static void describe(Describe<Servo>& d);

private:
    double wanted(Services& world) override { return target.read(world); }
    void publish(double at, double turning, double effort, bool isSaturated) override;
};

class LinearMotor final : public JointServo, public LinearMotorSignals {
public:
    static void describe(Describe<LinearMotor>& d);

private:
    double wanted(Services& world) override { return target.read(world); }
    void publish(double at, double moving, double effort, bool isSaturated) override;
};

} // namespace trundle
