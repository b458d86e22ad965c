// What joints do in each step: springs as implicit rows, stops that know the unwrapped angle, and what is read from them.
#include "world/ode/ode_engine.h"

#include <cmath>
#include <numbers>

namespace trundle {

namespace {

constexpr double kSoftEnough = 1e-6; // rad/s per N m: from here on the motor's law gives its torque to many digits

/// The multiple of a turn that brings `angle` nearest to where the rate says it is.
double unwrap(double angle, double expected) {
    return angle + 2 * std::numbers::pi * std::nearbyint((expected - angle) / (2 * std::numbers::pi));
}

/// Shortest rotation as axis times angle.
Vec3 rotationVector(Quat q) {
    if (q.w() < 0) q.coeffs() = -q.coeffs();
    const double s = q.vec().norm();
    return s < 1e-12 ? Vec3(2 * q.vec()) : Vec3(q.vec() * (2 * std::atan2(s, q.w()) / s));
}

void setRow(dJointID motor, bool linear, int axis, int parameter, double value) {
    if (linear) dJointSetLMotorParam(motor, parameter + axis * kParamStep, value);
    else dJointSetAMotorParam(motor, parameter + axis * kParamStep, value);
}

} // namespace

void OdeEngine::tendRows(double h) {
    for (const std::uint32_t index : m_tended) {
        Joint& joint = m_joints[index];
        if (joint.spring) tendSpring(joint, h);
        if (joint.stop) dJointSetAMotorAngle(joint.stop, 0, joint.position);
        if (joint.type == JointType::Suspension) tendSuspension(joint, h);
    }
}

/// Spring k and damper c as one row: rate target -k q / (h k + c), softness 1 / (h k + c). Stable at any h.
void OdeEngine::tendSpring(Joint& joint, double h) {
    const double give = h * joint.stiffness + joint.damping;
    const bool linear = joint.type == JointType::Slider;
    double away[3] = {joint.position, 0, 0};
    int axes = 1;
    if (joint.type == JointType::Ball || joint.type == JointType::Universal) {
        const Quat child = quat(m_bodies[joint.child].q),
                   parent = joint.parent == kNone ? Quat(1, 0, 0, 0) : quat(m_bodies[joint.parent].q);
        const Vec3 turned = rotationVector(parent.conjugate() * child * joint.start.conjugate());
        if (joint.type == JointType::Ball) {
            const Vec3 inWorld = parent * turned;
            axes = 3;
            for (int k = 0; k < 3; ++k) away[k] = inWorld[k];
        } else {
            axes = 2;
            away[1] = turned.dot(parent.conjugate() * (child * joint.slideAxis)); // about Axis2, which stays with the child
        }
    }
    for (int k = 0; k < axes; ++k) {
        setRow(joint.spring, linear, k, dParamVel, -joint.stiffness * away[k] / give);
        setRow(joint.spring, linear, k, dParamCFM, 1 / give);
    }
}

/// The wheel's anchor on its spring; past its travel the row turns hard.
void OdeEngine::tendSuspension(Joint& joint, double h) {
    const Vec3 gap = anchorGap(joint);
    const double slide = gap.dot(turn(m_bodies[joint.parent].r, joint.slideAxis));
    const double give = std::max(h * joint.stiffness + joint.damping, 1e-9);
    double erp = h * joint.stiffness / give, cfm = 1 / give;
    if (joint.travel > 0 && std::abs(slide) > joint.travel) {
        erp = m_settings.errorReduction * (std::abs(slide) - joint.travel) / std::abs(slide);
        cfm = kWorldCfm;
    }
    dJointSetHinge2Param(joint.id, dParamSuspensionERP, erp);
    dJointSetHinge2Param(joint.id, dParamSuspensionCFM, cfm);
}

void OdeEngine::applyMotor(Joint& joint) {
    joint.motorChanged = false;
    joint.driven = true;
    const double cfm = std::max(joint.motor.softness, kWorldCfm), limit = std::max(0.0, joint.motor.limit);
    const auto set = [&](auto setter, dJointID id) {
        setter(id, dParamVel, joint.motor.rate);
        setter(id, dParamCFM, cfm);
        setter(id, dParamFMax, limit);
    };
    switch (joint.type) {
    case JointType::Hinge: set(dJointSetHingeParam, joint.id); break;
    case JointType::Slider: set(dJointSetSliderParam, joint.id); break;
    case JointType::Universal:
    case JointType::Suspension:
        if (!joint.drive) {
            const Vec3 axis = turn(m_bodies[joint.child].r, joint.childAxis);
            joint.drive = axisMotor(joint, std::span(&axis, 1), joint.type == JointType::Universal);
        }
        set(dJointSetAMotorParam, joint.drive);
        break;
    case JointType::Ball:
    case JointType::Fixed: return; // nothing to drive; refused where a device asks for it
    }
    if (joint.motor.softness < kSoftEnough && joint.feedback == kNone) {
        joint.feedback = static_cast<std::uint32_t>(m_feedbacks.size());
        m_feedbacks.push_back(std::make_unique<dJointFeedback>());
        *m_feedbacks.back() = {};
        dJointSetFeedback(joint.drive ? joint.drive : joint.id, m_feedbacks.back().get());
    }
}

/// The child's anchor as seen from the parent's, world.
Vec3 OdeEngine::anchorGap(const Joint& joint) const {
    const Body& c = m_bodies[joint.child];
    Vec3 gap = vec(c.p) + turn(c.r, joint.childAnchor);
    if (joint.parent == kNone) return gap - joint.parentAnchor;
    const Body& p = m_bodies[joint.parent];
    return gap - vec(p.p) - turn(p.r, joint.parentAnchor);
}

void OdeEngine::measureJoint(Joint& joint, double h) {
    if (joint.type == JointType::Ball || joint.type == JointType::Fixed) return;
    const Body& c = m_bodies[joint.child];
    const Body* p = joint.parent == kNone ? nullptr : &m_bodies[joint.parent];
    const Vec3 axis = p ? turn(p->r, joint.parentAxis) : joint.parentAxis;
    if (joint.type == JointType::Slider) {
        const Vec3 lever = turn(c.r, joint.childAnchor);
        Vec3 speed = vec(c.v) + vec(c.w).cross(lever);
        if (p) speed -= vec(p->v) + vec(p->w).cross(vec(c.p) + lever - vec(p->p));
        joint.position = axis.dot(anchorGap(joint));
        joint.rate = axis.dot(speed);
    } else {
        const Quat relative = p ? Quat(quat(p->q).conjugate() * quat(c.q)) : quat(c.q),
                   turned = relative * joint.start.conjugate();
        joint.rate = axis.dot(p ? Vec3(vec(c.w) - vec(p->w)) : vec(c.w));
        const double angle = 2 * std::atan2(turned.vec().dot(joint.parentAxis), turned.w());
        joint.position = unwrap(angle, joint.position + joint.rate * h);
    }
    if (joint.driven) joint.effort = effortOf(joint);
}

/// What the motor row gave in this step: from its own law where that is soft, from the joint's reaction where it is stiff.
double OdeEngine::effortOf(const Joint& joint) const {
    const double limit = std::max(0.0, joint.motor.limit);
    if (limit == 0) return 0;
    if (joint.motor.softness >= kSoftEnough || joint.feedback == kNone)
        return std::clamp((joint.motor.rate - joint.rate) / std::max(joint.motor.softness, kWorldCfm), -limit, limit);
    const dJointFeedback& f = *m_feedbacks[joint.feedback];
    const Body& c = m_bodies[joint.child];
    const Vec3 axis = turn(c.r, joint.childAxis), force = vec(f.f1);
    if (joint.type == JointType::Slider) return axis.dot(force);
    if (joint.drive) return axis.dot(vec(f.t1));
    return axis.dot(vec(f.t1) - turn(c.r, joint.childAnchor).cross(force)); // the hinge's force acts at the anchor
}

} // namespace trundle
