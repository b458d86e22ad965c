// Joint constraint rows of each step (implicit springs, stops at the unwrapped angle), and joint measurements.
#include "world/ode/ode_engine.h"

#include <cmath>
#include <numbers>

namespace trundle {

namespace {

constexpr double kSoftEnough = 1e-6; // rad/s per N m; above it the torque can be computed accurately from the motor's law

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

void setRow(dJointID motor, bool linear, int axis, int parameter, double value) {
    if (linear) dJointSetLMotorParam(motor, parameter + axis * kParamStep, value);
    else dJointSetAMotorParam(motor, parameter + axis * kParamStep, value);
}

} // namespace

void OdeEngine::updateSpringConstraints(double h) {
    for (const std::uint32_t index : m_updated) {
        Joint& joint = m_joints[index];
        if (joint.spring) updateSpring(joint, h);
        if (joint.stop) dJointSetAMotorAngle(joint.stop, 0, joint.position);
        if (joint.type == JointType::Suspension) updateSuspension(joint, h);
    }
}

/// Spring k and damper c as one row: target rate -k q / (h k + c), softness 1 / (h k + c). Stable for any time step h.
void OdeEngine::updateSpring(Joint& joint, double h) {
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
            away[1] = turned.dot(parent.conjugate() * (child * joint.slideAxis)); // about Axis2, which is fixed to the child
        }
    }
    for (int k = 0; k < axes; ++k) {
        setRow(joint.spring, linear, k, dParamVel, -joint.stiffness * away[k] / give);
        setRow(joint.spring, linear, k, dParamCFM, 1 / give);
    }
}

/// Suspension spring of a wheel; beyond its travel the constraint becomes stiff.
void OdeEngine::updateSuspension(Joint& joint, double h) {
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
    case JointType::Fixed: return; // no motor; devices that request one are rejected earlier
    }
    if (joint.motor.softness < kSoftEnough && joint.feedback == kNone) {
        joint.feedback = static_cast<std::uint32_t>(m_feedbacks.size());
        m_feedbacks.push_back(std::make_unique<dJointFeedback>());
        *m_feedbacks.back() = {};
        dJointSetFeedback(joint.drive ? joint.drive : joint.id, m_feedbacks.back().get());
    }
}

/// Vector from the parent's anchor to the child's, in world coordinates.
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

/// Torque or force of the motor row in this step: from the motor's law if it is soft, from the joint's reaction if it is stiff.
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
    return axis.dot(vec(f.t1) - turn(c.r, joint.childAnchor).cross(force)); // the hinge force acts at the anchor
}

} // namespace trundle
