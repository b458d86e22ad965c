#include "world/ode/joints/axis_motor.h"

#include "world/ode/objects/ode_math.h"

namespace trundle {
namespace {

/// Attaches the child as first body, then the parent or the world.
dJointID attached(dJointID id, const OdeJoint& joint, const std::vector<OdeBody>& bodies) {
    dJointAttach(id, bodies[joint.child].id, joint.parent == kNone ? nullptr : bodies[joint.parent].id);
    return id;
}

} // namespace

void setRow(dJointID motor, JointType of, int axis, int parameter, double value) {
    if (of == JointType::Slider) dJointSetLMotorParam(motor, parameter + axis * kParamStep, value);
    else dJointSetAMotorParam(motor, parameter + axis * kParamStep, value);
}

double rowOf(dJointID motor, JointType of, int axis, int parameter) {
    const int row = parameter + axis * kParamStep;
    return of == JointType::Slider ? dJointGetLMotorParam(motor, row) : dJointGetAMotorParam(motor, row);
}

void scaleStops(const OdeJoint& joint, double factor) {
    if (!joint.stop) return;
    if (joint.type == JointType::Slider)
        return dJointSetSliderParam(joint.id, dParamStopERP, factor * dJointGetSliderParam(joint.id, dParamStopERP));
    for (int k = 0; k < dJointGetAMotorNumAxes(joint.stop); ++k)
        setRow(joint.stop, joint.type, k, dParamStopERP, factor * rowOf(joint.stop, joint.type, k, dParamStopERP));
}

Vec3 axisNow(const OdeJoint& joint, const std::vector<OdeBody>& bodies) {
    if (joint.type != JointType::Universal) return turn(bodies[joint.child].r, joint.childAxis);
    return joint.parent == kNone ? joint.parentAxis : turn(bodies[joint.parent].r, joint.parentAxis);
}

dJointID axisMotor(const OdeJoint& joint, const std::vector<OdeBody>& bodies, std::span<const Vec3> axes, int ofParent) {
    const dWorldID world = dBodyGetWorld(bodies[joint.child].id);
    const bool linear = joint.type == JointType::Slider;
    const dJointID motor =
        attached(linear ? dJointCreateLMotor(world, nullptr) : dJointCreateAMotor(world, nullptr), joint, bodies);
    if (linear) dJointSetLMotorNumAxes(motor, static_cast<int>(axes.size()));
    else dJointSetAMotorNumAxes(motor, static_cast<int>(axes.size()));
    const int withParent = joint.parent == kNone ? 0 : 2; // axis fixed to the parent, or to the world
    const int withChild = joint.type == JointType::Ball ? 0 : 1;
    for (int i = 0; i < static_cast<int>(axes.size()); ++i) {
        const Vec3& a = axes[static_cast<std::size_t>(i)];
        if (linear) dJointSetLMotorAxis(motor, i, withParent, a.x(), a.y(), a.z());
        else dJointSetAMotorAxis(motor, i, i < ofParent ? withParent : withChild, a.x(), a.y(), a.z());
    }
    return motor;
}

/// Rows of a slider turn with neither of its bodies. Those of a ball are about the axes of the world itself.
void setWorldAxes(dJointID motor, const OdeJoint& joint) {
    const Vec3& a = joint.parentAxis;
    if (joint.type == JointType::Slider)
        for (int i = 0; i < dJointGetLMotorNumAxes(motor); ++i) dJointSetLMotorAxis(motor, i, 0, a.x(), a.y(), a.z());
    if (joint.type != JointType::Universal) return;
    for (int i = 0; i < dJointGetAMotorNumAxes(motor); ++i)
        if (dJointGetAMotorAxisRel(motor, i) == 0) dJointSetAMotorAxis(motor, i, 0, a.x(), a.y(), a.z());
}

} // namespace trundle
