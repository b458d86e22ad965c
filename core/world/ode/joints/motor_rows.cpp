// Motors: rows that drive a joint. Method: a soft row is a line, effort = (rate - w) / softness; its back-EMF is integrated as a damper
// of second order (spring_row.h) while the child touches nothing. On the ground the row's own inertia is not what it moves, and the
// implicit Euler of a plain row has the exact way that a base lags behind its voltage. A servo is a source of voltage and a damper:
// between -limit and limit - damping * w, along the motion, lie limit - damping * w / 2 to both sides of -damping * w / 2.
#include "world/ode/joints/joint_rows.h"

#include <algorithm>
#include <cmath>

#include "world/ode/joints/drive_friction.h"
#include "world/ode/objects/ode_math.h"

namespace trundle {

namespace {

constexpr double kSoftEnough = 1e-6;  // rad/s per N m; above it the torque can be computed accurately from the motor's law
constexpr double kFarFromLine = 0.5;  // share of the torque at hand up to which a servo needs no damper of its own
constexpr double kSmallChange = 0.02; // of the no-load rate
constexpr double kLeastReserve = 0.1; // of the limit

} // namespace

void JointRows::setMotor(std::uint32_t index, const MotorConstraint& motor) {
    OdeJoint& joint = m_joints[index];
    if (joint.driven && joint.motor == motor) return;
    if (!joint.driven) m_driven.push_back(index);
    joint.motor = motor;
    joint.driven = joint.motorChanged = true;
}

/// Of a motor whose line is a damper of the joint in this step.
double JointRows::motorDamping(const OdeJoint& joint) const {
    const MotorConstraint& motor = joint.motor;
    const bool line = joint.driven && motor.damping == 0 && motor.softness >= kSoftEnough && motor.limit > 0;
    return line && joint.type == JointType::Hinge && !m_touched[joint.child] ? 1 / motor.softness : 0;
}

void JointRows::updateMotor(OdeJoint& joint, double h) {
    joint.motorChanged = false;
    const MotorConstraint& motor = joint.motor;
    if (joint.losses || motor.dryFriction > 0 || motor.viscousFriction > 0) updateLosses(joint, h);
    if (motor.damping > 0) return updateServo(joint, h);
    if (joint.damper) setRow(joint.damper, joint.type, 0, dParamFMax, 0);
    joint.damperGive = 0;
    const double limit = std::max(0.0, motor.limit);
    if (motor.softness < kSoftEnough || m_touched[joint.child])
        return writeMotor(joint, motor.rate, std::max(motor.softness, kWorldCfm), limit);
    const double slope = 1 / motor.softness;
    const SpringRow row = damperRow(joint, slope, slope + dampingOf(joint), h);
    writeMotor(joint, (motor.rate / motor.softness - row.carry * joint.rate) / row.give, 1 / row.give, limit);
}

/// Far from its limits, and where it has its whole limit, a servo is only a stiff row.
void JointRows::updateServo(OdeJoint& joint, double h) {
    const double rate = joint.motor.rate, limit = joint.motor.limit, damping = joint.motor.damping;
    const double now = std::abs(joint.rate), reserve = limit - damping * now;
    const bool near = std::abs(joint.effort) > kFarFromLine * reserve || reserve < kLeastReserve * limit ||
                      damping * std::abs(rate - joint.rate) > kSmallChange * limit;
    if (near && !joint.damper) {
        const Vec3 axis = axisNow(joint, m_bodies);
        joint.damper = axisMotor(joint, m_bodies, std::span(&axis, 1),
                                 joint.type == JointType::Universal || joint.type == JointType::Slider);
    }
    const bool brakes = joint.rate * rate >= 0 && damping * (now - std::abs(rate)) > kSmallChange * limit;
    const bool whole = brakes || damping * now / 2 >= limit; // so fast that its line lies below -limit
    if (whole || !near) {
        if (joint.damper) setRow(joint.damper, joint.type, 0, dParamFMax, 0);
        joint.damperGive = 0;
        return writeMotor(joint, rate, kWorldCfm, !whole && joint.effort * joint.rate >= 0 ? reserve : limit);
    }
    SpringRow row{damping, 0};
    if (!m_touched[joint.child]) row = damperRow(joint, damping, damping + dampingOf(joint), h);
    joint.damperGive = row.give;
    joint.damperRate = joint.rate * (row.give - damping / 2) / row.give;
    setRow(joint.damper, joint.type, 0, dParamVel, joint.damperRate);
    setRow(joint.damper, joint.type, 0, dParamCFM, 1 / row.give);
    setRow(joint.damper, joint.type, 0, dParamFMax, dInfinity);
    writeMotor(joint, rate, kWorldCfm, std::max(0.0, limit - damping * now / 2));
}

void JointRows::writeMotor(OdeJoint& joint, double rate, double cfm, double limit) {
    const auto set = [&](auto setter, dJointID id) {
        setter(id, dParamVel, rate);
        setter(id, dParamCFM, cfm);
        setter(id, dParamFMax, limit);
    };
    switch (joint.type) {
    case JointType::Hinge: set(dJointSetHingeParam, joint.id); break;
    case JointType::Slider:
        if (joint.drive) set(dJointSetLMotorParam, joint.drive);
        else set(dJointSetSliderParam, joint.id);
        break;
    case JointType::Universal:
    case JointType::Suspension:
        if (!joint.drive) {
            const Vec3 axis = axisNow(joint, m_bodies);
            joint.drive = axisMotor(joint, m_bodies, std::span(&axis, 1), joint.type == JointType::Universal);
        }
        set(dJointSetAMotorParam, joint.drive);
        break;
    case JointType::Ball:
    case JointType::Fixed: return; // no motor; devices that request one are rejected earlier
    }
    if (joint.motor.softness < kSoftEnough && joint.feedback == kNone) {
        joint.feedback = static_cast<std::uint32_t>(m_feedbacks.size());
        dJointSetFeedback(joint.drive ? joint.drive : joint.id, makeFeedback());
    }
}

dJointFeedback* JointRows::makeFeedback() {
    m_feedbacks.push_back(std::make_unique<dJointFeedback>());
    *m_feedbacks.back() = {};
    return m_feedbacks.back().get();
}

void JointRows::updateLosses(OdeJoint& joint, double h) {
    SpringRow row{joint.motor.viscousFriction, 0};
    if (row.give > 0 && !m_touched[joint.child]) row = damperRow(joint, row.give, motorDamping(joint) + dampingOf(joint), h);
    if (!joint.losses) addFrictionRows(joint, m_bodies, makeFeedback());
    setFrictionRows(joint, row);
}

/// Torque or force of the motor at the end of the step: by its law where that is a line, else the joint's reaction.
double JointRows::effortOf(const OdeJoint& joint) const {
    const MotorConstraint& motor = joint.motor;
    const double limit = std::max(0.0, motor.limit);
    if (limit == 0) return 0;
    if (motor.damping == 0 && (motor.softness >= kSoftEnough || joint.feedback == kNone))
        return std::clamp((motor.rate - joint.rate) / std::max(motor.softness, kWorldCfm), -limit, limit);
    const dJointFeedback& f = *m_feedbacks[joint.feedback];
    const Vec3 &axis = joint.startAxis, force = vec(f.f1);
    double effort = 0;
    if (joint.type == JointType::Slider) effort = axis.dot(force);
    else if (joint.drive) effort = axis.dot(vec(f.t1));
    else effort = axis.dot(vec(f.t1) - joint.startArm.cross(force)); // the hinge force acts at the anchor
    if (motor.damping == 0) return effort;
    effort += joint.damperGive * (joint.damperRate - joint.rate);
    const double most = std::max(-limit, limit - motor.damping * std::abs(joint.rate));
    return std::clamp(effort, joint.rate < 0 ? -most : -limit, joint.rate > 0 ? most : limit);
}

} // namespace trundle
