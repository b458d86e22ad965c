#include "world/ode/joints/drive_friction.h"

#include "world/ode/joints/axis_motor.h"
#include "world/ode/objects/ode_math.h"

namespace trundle {

double dampingOf(const OdeJoint& joint) {
    const bool wheel = joint.type == JointType::Suspension; // its damping is along the spring
    return (wheel ? 0 : joint.damping) + (joint.driven ? joint.motor.viscousFriction : 0);
}

SpringRow damperRow(const OdeJoint& joint, double damping, double all, double h) {
    const SpringRow row = springRow(0, all, joint.inertia[joint.type == JointType::Suspension ? 1 : 0], h);
    return {row.give * damping / all, row.carry * damping / all};
}

void addFrictionRows(OdeJoint& joint, const std::vector<OdeBody>& bodies, dJointFeedback* feedback) {
    const Vec3 axis = axisNow(joint, bodies), axes[] = {axis, axis};
    joint.losses = axisMotor(joint, bodies, axes,
                             joint.type == JointType::Universal ? 2
                             : joint.type == JointType::Slider  ? 1
                                                                : 0);
    dJointSetFeedback(joint.losses, feedback);
}

void setFrictionRows(const OdeJoint& joint, const SpringRow& viscous) {
    setRow(joint.losses, joint.type, 0, dParamFMax, joint.motor.dryFriction);
    setRow(joint.losses, joint.type, 1, dParamFMax, viscous.give > 0 ? dInfinity : 0);
    if (!(viscous.give > 0)) return;
    setRow(joint.losses, joint.type, 1, dParamVel, -viscous.carry * joint.rate / viscous.give);
    setRow(joint.losses, joint.type, 1, dParamCFM, 1 / viscous.give);
}

double frictionEffortOf(const OdeJoint& joint) {
    if (!joint.losses) return 0;
    const dJointFeedback& f = *dJointGetFeedback(joint.losses);
    return joint.startAxis.dot(vec(joint.type == JointType::Slider ? f.f1 : f.t1));
}

} // namespace trundle
