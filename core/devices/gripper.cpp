#include "devices/gripper.h"

#include <algorithm>
#include <cmath>

namespace trundle {

namespace {

constexpr double kGearPlay = 0.02; // m: by how much one jaw leads when the gear gives the other one half of the force more
constexpr double kMostShift = 0.5; // of Force: from one jaw to the other
constexpr double kHolding = 0.95, kStill = 0.01; // of Force; of MaxSpeed

} // namespace

void Gripper::describe(Describe<Gripper>& d) {
    d.help("Two jaws on sliders, which close with a force and hold by friction.").independent();
    d.field("Left", &Gripper::m_leftName, reference("Slider").required(), "The slider of one jaw; a positive position opens it.");
    d.field("Right", &Gripper::m_rightName, reference("Slider").required(), "The slider of the other jaw.");
    d.field("Force", &Gripper::m_force, newtons().within(1e-9, 1e9).required().live(), "With which each jaw presses, at rest.");
    d.field("MaxSpeed", &Gripper::m_maxSpeed, metresPerSecond().within(1e-6, 1e3).live(), "Of each jaw, without load.");
    d.field("TimeConstant", &Gripper::m_timeConstant, seconds().within(0, 1e3).live(),
            "The way to go shrinks by 63 % in this time; 0: in one tick.");
    GripperSignals::describe(d);
}

void Gripper::setup(Mount& mount) {
    if (m_leftName == m_rightName) return mount.fail("Left and Right are the same slider");
    m_left.joint = mount.joint(m_leftName);
    m_right.joint = mount.joint(m_rightName);
}

void Gripper::move(Actuation& world, Jaw& jaw, double target, double force, double share) const {
    const double way = target - world.jointPosition(jaw.joint);
    jaw.rate = std::clamp(way / std::max(m_timeConstant, double(world.tick())), -m_maxSpeed * share, m_maxSpeed * share);
    world.servoRow(jaw.joint, jaw.rate, force * share, m_force / m_maxSpeed);
}

/// The gear keeps the jaws in step: the one that is more open presses harder, the other one less.
void Gripper::act(Actuation& world) {
    const Supply supply = world.supply();
    const double share = supply.present ? supply.voltage / supply.nominal : 1;
    const double target = opening.read(world) / 2;
    const double lead = world.jointPosition(m_left.joint) - world.jointPosition(m_right.joint);
    const double shift = std::clamp((lead + (lead - m_lastLead)) / kGearPlay, -kMostShift, kMostShift) * m_force;
    m_lastLead = lead;
    move(world, m_left, target, m_force + shift, share);
    move(world, m_right, target, m_force - shift, share);
}

void Gripper::sense(Sensing& world) {
    double pressing = 0, fastest = 0, watts = 0;
    for (const Jaw& jaw : {m_left, m_right}) {
        const double effort = world.jointMotorEffort(jaw.joint), rate = world.jointRate(jaw.joint);
        pressing -= effort / 2;
        fastest = std::max(fastest, std::abs(rate));
        watts += effort * rate + effort * effort * m_maxSpeed / m_force; // as a Servo
    }
    const Supply supply = world.supply();
    const double most = supply.present ? m_force * supply.voltage / supply.nominal : m_force;
    position.set(world.jointPosition(m_left.joint) + world.jointPosition(m_right.joint));
    force.set(pressing);
    holding.set(pressing > kHolding * most && most > 0 && fastest < kStill * m_maxSpeed);
    if (supply.voltage > 0) world.draw(watts);
}

} // namespace trundle
