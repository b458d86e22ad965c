#pragma once
#include <trundle/device.h>
#include <trundle/device_signals.h>

namespace trundle {

/// Two jaws on sliders that one gear moves together: a positive position of each slider opens its jaw. They close with at most Force, and
/// hold by friction alone. The only owner of the motor constraints of both joints.
class Gripper final : public Device, public GripperSignals {
public:
    static void describe(Describe<Gripper>& d);
    /// Fails if both jaws are on the same slider.
    void setup(Mount& mount) override;
    void act(Actuation& world) override;
    void sense(Sensing& world) override;

private:
    struct Jaw {
        JointId joint;
        double rate = 0; ///< that it is to have in this tick, m/s
    };
    void move(Actuation& world, Jaw& jaw, double target, double force, double share) const;

    std::string m_leftName, m_rightName;
    double m_force = 0, m_maxSpeed = 0.05, m_timeConstant = 0.05; ///< N, m/s, s

    Jaw m_left, m_right;
    double m_lastLead = 0; ///< m
};

} // namespace trundle
