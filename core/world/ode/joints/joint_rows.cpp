#include "world/ode/joints/joint_rows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "world/ode/joints/drive_friction.h"
#include "world/ode/objects/ode_math.h"

namespace trundle {

namespace {

constexpr std::uint32_t kInertiaTicks = 16; // an estimate for a row of second order need not follow each tick
constexpr double kLeastGive = 1e-9;         // N m s
constexpr double kUpright = 1e-6;           // sine of a tilt without a direction
constexpr double kPressed = 0.3;            // cosine between a joint's motion and a contact's normal
constexpr double kStopStiffness = 1000;     // of a suspension beyond its travel, in masses per tick squared

/// Adds the multiple of a full turn that brings `angle` closest to the angle expected from the rate.
double unwrap(double angle, double expected) {
    return angle + 2 * std::numbers::pi * std::nearbyint((expected - angle) / (2 * std::numbers::pi));
}

/// The shortest rotation as axis times angle (rad).
Vec3 rotationVector(Quat q) {
    if (q.w() < 0) q.coeffs() = -q.coeffs();
    const double s = q.vec().norm();
    return s < 1e-12 ? Vec3(2 * q.vec()) : Vec3(q.vec() * (2 * std::atan2(s, q.w()) / s));
}

/// A motion along a free axis, and where it ends.
struct Limited {
    double position, rate, low, high;
};

/// A stop can be reached in any tick, so ODE's own row of the nearer one always acts: the rate may be what leads onto it within the tick, and
/// beyond it is what leads back by a share. ODE takes its rate from how far the stop is passed and from its gain: 1, and less than 0 before
/// the stop.
void limitAxis(const OdeJoint& joint, int axis, const Limited& m, double h, double errorReduction) {
    if (m.low == -dInfinity && m.high == dInfinity) return;
    const double down = m.position - m.low, up = m.high - m.position, step = h * m.rate;
    const bool high = up - step < down + step;
    const double room = high ? up : down, gain = room < 0 ? -errorReduction * room : -room;
    if (joint.type == JointType::Slider) {
        const double at = dJointGetSliderPosition(joint.id);
        const bool isLocked = m.low == m.high; // by two equal stops of ODE
        dJointSetSliderParam(joint.id, dParamLoStop, isLocked && high ? at - 1 : high ? -dInfinity : at + 1);
        dJointSetSliderParam(joint.id, dParamHiStop, isLocked && !high ? at + 1 : high ? at - 1 : dInfinity);
        dJointSetSliderParam(joint.id, dParamStopERP, gain);
        return;
    }
    dJointSetAMotorAngle(joint.stop, axis, high ? m.high + 1 : m.low - 1);
    setRow(joint.stop, joint.type, axis, dParamStopERP, gain);
}

/// `give`: N s/m.
void setSuspensionRow(dJointID suspension, double errorReduction, double give) {
    dJointSetHinge2Param(suspension, dParamSuspensionERP, errorReduction);
    dJointSetHinge2Param(suspension, dParamSuspensionCFM, 1 / give);
}

/// Beyond its travel a much stiffer spring is added to that of a suspension: a row that only held it there would hold it for good. False:
/// it is not beyond. `slide`: m.
bool setEndOfTravel(OdeJoint& joint, double slide, double h, double errorReduction) {
    const double past = std::abs(slide) - joint.travel;
    joint.beyond = joint.travel > 0 && past > 0 ? std::copysign(past, slide) : 0;
    if (joint.beyond == 0) return false;
    const double stiffness = kStopStiffness * joint.inertia[0] / (h * h), give = h * stiffness / errorReduction;
    const double force = joint.stiffness * joint.travel + stiffness * past;
    setSuspensionRow(joint.id, h * force / (give * std::abs(slide)), give);
    return true;
}

/// The stop of a ball acts about the axis about which the child's axis will be tilted from the parent's at the end of the tick: in a narrow
/// cone that is another one than now.
void updateCone(OdeJoint& joint, const std::vector<OdeBody>& bodies, double h, double errorReduction) {
    const Vec3 parent = (joint.parent == kNone ? joint.parentAxis : turn(bodies[joint.parent].r, joint.parentAxis)),
               child = turn(bodies[joint.child].r, joint.childAxis), across = parent.cross(child);
    const Vec3 spin = vec(bodies[joint.child].w) - (joint.parent == kNone ? Vec3(Vec3::Zero()) : vec(bodies[joint.parent].w));
    const double sine = across.norm(), angle = std::atan2(sine, parent.dot(child));
    const Vec3 tilt = sine < kUpright ? Vec3(Vec3::Zero()) : Vec3(angle / sine * across);
    const Vec3 next = angle > joint.highStop ? tilt : Vec3(tilt + h * (spin - spin.dot(parent) * parent));
    const bool hasNone = next.norm() < kUpright; // upright, or upside down where no cone ends
    joint.position = hasNone ? 0 : angle;
    if (hasNone) return dJointSetAMotorAngle(joint.stop, 0, 0);
    const Vec3 axis = next.normalized();
    joint.rate = axis.dot(spin);
    dJointSetAMotorAxis(joint.stop, 0, 0, axis.x(), axis.y(), axis.z());
    limitAxis(joint, 0, {tilt.dot(axis), joint.rate, joint.lowStop, joint.highStop}, h, errorReduction);
}

/// The child's rotation from where it started, in the parent's axes.
Quat turnedFromStart(const OdeJoint& joint, const std::vector<OdeBody>& bodies) {
    const Quat child = quat(bodies[joint.child].q);
    return (joint.parent == kNone ? child : Quat(quat(bodies[joint.parent].q).conjugate() * child)) * joint.start.conjugate();
}

/// Of a universal joint: the halves of its two angles have the components of `turned` along its axes as products, so that each angle
/// is that about its own axis, however large the other one is.
void measureSecond(OdeJoint& joint, const OdeBody& child, const Quat& turned, const Vec3& spin, double h) {
    const Vec3 axis = joint.start * joint.secondAxis;
    joint.rate2 = turn(child.r, joint.secondAxis).dot(spin);
    joint.position2 = unwrap(2 * std::atan2(turned.vec().dot(axis), turned.w()), joint.position2 + joint.rate2 * h);
}

void keepStart(OdeJoint& joint, const std::vector<OdeBody>& bodies) {
    joint.startAxis = axisNow(joint, bodies);
    joint.startArm = turn(bodies[joint.child].r, joint.childAnchor);
}

} // namespace

void JointRows::forget(std::uint32_t joint) {
    for (auto* const list : {&m_updated, &m_driven}) std::erase_if(*list, [joint](std::uint32_t i) { return i >= joint; });
    m_inertias.forgetRemoved();
}

void JointRows::add(std::uint32_t index, const JointSpec& spec, const Vec3& axis, const Vec3& axis2) {
    OdeJoint& joint = m_joints[index];
    m_inertias.add(index);
    if (spec.type == JointType::Fixed) return;
    std::vector<Vec3> axes{axis};
    if (spec.type == JointType::Universal) axes.push_back(axis2);
    if (spec.type == JointType::Ball) axes = {Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
    const bool withParent = spec.type == JointType::Universal || spec.type == JointType::Slider;
    const auto set = [&](dJointID motor, int parameter, double value) {
        for (int i = 0; i < static_cast<int>(axes.size()); ++i) setRow(motor, spec.type, i, parameter, value);
    };
    if (spec.type != JointType::Suspension) addStop(joint, spec, axis, axis2);
    if (spec.friction > 0) {
        joint.friction = axisMotor(joint, m_bodies, axes, withParent);
        set(joint.friction, dParamFMax, spec.friction);
    }
    const bool isSprung = spec.stiffness > 0 || spec.damping > 0 ||
                          (spec.type == JointType::Universal && (joint.stiffness2 > 0 || joint.damping2 > 0));
    if (spec.type != JointType::Suspension && isSprung) {
        joint.spring = axisMotor(joint, m_bodies, axes, withParent);
        set(joint.spring, dParamFMax, dInfinity);
    }
    if (spec.type == JointType::Suspension && !dJointGetFeedback(joint.id)) dJointSetFeedback(joint.id, makeFeedback());
    if (joint.stop || joint.spring || spec.type == JointType::Suspension) m_updated.push_back(index);
}

/// A separate stop that uses the unwrapped angle, since ODE's own is limited to half a turn in each direction. That of a slider is
/// ODE's own; its motor is separate, because ODE drives a slider at its stop without bound.
void JointRows::addStop(OdeJoint& joint, const JointSpec& spec, const Vec3& axis, const Vec3& axis2) const {
    const bool isBall = spec.type == JointType::Ball, isUniversal = spec.type == JointType::Universal;
    const bool second = isUniversal && (spec.lowStop2 || spec.highStop2);
    if (isBall ? !spec.swingStop : !spec.lowStop && !spec.highStop && !second) return;
    joint.lowStop = isBall ? -dInfinity : spec.lowStop.value_or(-dInfinity);
    joint.highStop = isBall ? *spec.swingStop : spec.highStop.value_or(dInfinity);
    joint.lowStop2 = spec.lowStop2.value_or(-dInfinity);
    joint.highStop2 = spec.highStop2.value_or(dInfinity);
    const Vec3 axes[] = {axis, axis2};
    joint.stop = axisMotor(joint, m_bodies, std::span(axes, second ? 2 : 1), isUniversal);
    if (joint.type == JointType::Slider) {
        joint.drive = axisMotor(joint, m_bodies, std::array{axis}, true);
        return;
    }
    for (int k = 0; k < (second ? 2 : 1); ++k) {
        dJointSetAMotorAngle(joint.stop, k, 0);
        setRow(joint.stop, joint.type, k, dParamLoStop, k == 0 ? joint.lowStop : joint.lowStop2);
        setRow(joint.stop, joint.type, k, dParamHiStop, k == 0 ? joint.highStop : joint.highStop2);
    }
}

void JointRows::update(double h, std::span<const OdeContact> contacts, std::span<const OdeGeom> geoms, double errorReduction) {
    findTouches(contacts, geoms);
    for (const std::uint32_t index : m_updated) {
        OdeJoint& joint = m_joints[index];
        if (joint.spring || joint.type == JointType::Suspension) updateInertia(index);
        if (joint.spring) updateSpring(joint, h);
        if (joint.stop) updateStop(joint, h, errorReduction);
        if (joint.type == JointType::Suspension) updateSuspension(joint, h, errorReduction);
    }
    for (const std::uint32_t index : m_driven) {
        OdeJoint& joint = m_joints[index];
        const bool damped = joint.motor.damping > 0 || joint.motor.softness > 0 || joint.motor.viscousFriction > 0;
        if (damped && !m_touched[joint.child]) updateInertia(index);
        if (joint.motorChanged || damped) updateMotor(joint, h);
        if (joint.feedback != kNone || joint.losses) keepStart(joint, m_bodies);
    }
    ++m_ticks;
}

void JointRows::updateInertia(std::uint32_t index) {
    OdeJoint& joint = m_joints[index];
    if (joint.inertia[0] == 0 || (m_ticks + joint.order) % kInertiaTicks == 0) m_inertias.update(joint, index);
}

void JointRows::findTouches(std::span<const OdeContact> contacts, std::span<const OdeGeom> geoms) {
    m_touched.assign(m_driven.empty() ? 0 : m_bodies.size(), false);
    m_firstTouch.assign(m_updated.empty() ? 0 : m_bodies.size(), kNone);
    m_touches.clear();
    if (m_touched.empty() && m_firstTouch.empty()) return;
    for (const OdeContact& c : contacts) {
        const std::uint32_t first = geoms[c.first].body, second = geoms[c.second].body;
        if (!m_touched.empty()) {
            m_touched[first] = true;
            if (second != kNone) m_touched[second] = true;
        }
        if (second != kNone || m_firstTouch.empty()) continue;
        m_touches.push_back({m_firstTouch[first], vec(c.position), vec(c.normal)});
        m_firstTouch[first] = static_cast<std::uint32_t>(m_touches.size() - 1);
    }
}

/// True if a push (along the child's positive motion) presses what the child carries onto something that does not move: the spring
/// then moves only what is on its other side.
bool JointRows::isHeld(const OdeJoint& joint, double push) const {
    if (joint.parent == kNone) return false;
    const Vec3 anchor = vec(m_bodies[joint.child].p) + turn(m_bodies[joint.child].r, joint.childAnchor),
               axis = carried(joint, joint.type == JointType::Suspension ? joint.slideAxis : joint.parentAxis);
    for (const std::uint32_t body : joint.childSide)
        for (std::uint32_t i = m_firstTouch[body]; i != kNone; i = m_touches[i].next) {
            const Touch& touch = m_touches[i];
            const Vec3 motion = joint.type == JointType::Hinge ? Vec3(axis.cross(touch.position - anchor)) : axis;
            const double out = motion.dot(touch.normal);
            if (push * out <= 0 && std::abs(out) > kPressed * motion.norm()) return true;
        }
    return false;
}

void JointRows::updateStop(OdeJoint& joint, double h, double errorReduction) const {
    if (joint.type == JointType::Ball) return updateCone(joint, m_bodies, h, errorReduction);
    limitAxis(joint, 0, {joint.position, joint.rate, joint.lowStop, joint.highStop}, h, errorReduction);
    if (joint.type == JointType::Universal && dJointGetAMotorNumAxes(joint.stop) > 1)
        limitAxis(joint, 1, {joint.position2, joint.rate2, joint.lowStop2, joint.highStop2}, h, errorReduction);
}

void JointRows::updateSpring(OdeJoint& joint, double h) const {
    double away[3] = {joint.position - joint.rest, joint.position2, 0}, rate[3] = {joint.rate, joint.rate2, 0};
    const int axes = joint.type == JointType::Ball ? 3 : joint.type == JointType::Universal ? 2 : 1;
    if (axes == 3) {
        const OdeBody* p = joint.parent == kNone ? nullptr : &m_bodies[joint.parent];
        const Vec3 all = rotationVector(turnedFromStart(joint, m_bodies)), tilt = p ? turn(p->r, all) : all;
        const Vec3 spin = p ? Vec3(vec(m_bodies[joint.child].w) - vec(p->w)) : vec(m_bodies[joint.child].w);
        for (int k = 0; k < 3; ++k) {
            away[k] = tilt[k];
            rate[k] = spin[k];
        }
    }
    const bool held = axes == 1 && joint.stiffness > 0 && isHeld(joint, -away[0]);
    const double motor = motorDamping(joint) + (joint.driven && axes == 1 ? joint.motor.viscousFriction : 0);
    for (int k = 0; k < axes; ++k) {
        const bool second = axes == 2 && k == 1;
        const double stiffness = second ? joint.stiffness2 : joint.stiffness, damping = second ? joint.damping2 : joint.damping;
        SpringRow row = springRow(stiffness, damping + motor, (held ? joint.heldInertia : joint.inertia)[k], h);
        if (motor > 0) { // the share of motor and friction is in their own rows
            const SpringRow share = damperRow(joint, motor, motor + joint.damping, h);
            row = {row.give - share.give, row.carry - share.carry};
        }
        row.give = std::max(row.give, kLeastGive);
        setRow(joint.spring, joint.type, k, dParamVel, -(stiffness * away[k] + row.carry * rate[k]) / row.give);
        setRow(joint.spring, joint.type, k, dParamCFM, 1 / row.give);
    }
}

/// The spring along a suspension's axis is ODE's own row, which has no place for the force that only depends on the old rate.
void JointRows::updateSuspension(OdeJoint& joint, double h, double errorReduction) const {
    const Vec3 axis = carried(joint, joint.slideAxis);
    const Vec3 gap = anchorGap(joint), couple = gap.cross(joint.slideForce);
    const double slide = axis.dot(gap);
    joint.dampForce.setZero();
    // ODE lets the forces of both bodies act at their own anchors, which are apart: the parent's is moved to where the wheel is.
    dBodyAddTorque(m_bodies[joint.parent].id, couple.x(), couple.y(), couple.z());
    if (setEndOfTravel(joint, slide, h, errorReduction)) return;
    const double inertia = (isHeld(joint, -slide) ? joint.heldInertia : joint.inertia)[0];
    const SpringRow row = springRow(joint.stiffness, joint.damping, inertia, h);
    const double give = std::max(row.give, 1e-9);
    setSuspensionRow(joint.id, h * joint.stiffness / give, give);
    if (row.carry == 0) return;
    const OdeBody &c = m_bodies[joint.child], &p = m_bodies[joint.parent];
    const Vec3 force = -row.carry * axis.dot(anchorSpeed(joint)) * axis, at = vec(c.p) + turn(c.r, joint.childAnchor);
    joint.dampForce = force;
    dBodyAddForceAtPos(c.id, force.x(), force.y(), force.z(), at.x(), at.y(), at.z());
    dBodyAddForceAtPos(p.id, -force.x(), -force.y(), -force.z(), at.x(), at.y(), at.z());
}

Vec3 JointRows::carried(const OdeJoint& joint, const Vec3& axis) const {
    return joint.parent == kNone ? axis : turn(m_bodies[joint.parent].r, axis);
}

Vec3 JointRows::anchorGap(const OdeJoint& joint) const {
    const OdeBody& c = m_bodies[joint.child];
    Vec3 gap = vec(c.p) + turn(c.r, joint.childAnchor);
    if (joint.parent == kNone) return gap - joint.parentAnchor;
    const OdeBody& p = m_bodies[joint.parent];
    return gap - vec(p.p) - turn(p.r, joint.parentAnchor);
}

/// Velocity of the child's anchor relative to the parent, world.
Vec3 JointRows::anchorSpeed(const OdeJoint& joint) const {
    const OdeBody& c = m_bodies[joint.child];
    const Vec3 lever = turn(c.r, joint.childAnchor);
    Vec3 speed = vec(c.v) + vec(c.w).cross(lever);
    if (joint.parent == kNone) return speed;
    const OdeBody& p = m_bodies[joint.parent];
    return speed - (vec(p.v) + vec(p.w).cross(vec(c.p) + lever - vec(p.p)));
}

void JointRows::measure(OdeJoint& joint, double h) const {
    if (joint.type == JointType::Ball || joint.type == JointType::Fixed) return;
    if (joint.type == JointType::Suspension) joint.slideForce = vec(dJointGetFeedback(joint.id)->f1);
    const OdeBody& c = m_bodies[joint.child];
    const OdeBody* p = joint.parent == kNone ? nullptr : &m_bodies[joint.parent];
    const Vec3 axis = carried(joint, joint.parentAxis);
    if (joint.type == JointType::Slider) {
        joint.position = axis.dot(anchorGap(joint));
        joint.rate = axis.dot(anchorSpeed(joint));
    } else {
        const Quat turned = turnedFromStart(joint, m_bodies);
        const Vec3 spin = p ? Vec3(vec(c.w) - vec(p->w)) : vec(c.w);
        joint.rate = axis.dot(spin);
        const double angle = 2 * std::atan2(turned.vec().dot(joint.parentAxis), turned.w());
        joint.position = unwrap(angle, joint.position + joint.rate * h);
        if (joint.type == JointType::Universal) measureSecond(joint, c, turned, spin, h);
    }
    if (!joint.driven) return;
    joint.effort = effortOf(joint);
    joint.frictionEffort = frictionEffortOf(joint);
}

} // namespace trundle
