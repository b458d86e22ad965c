#include "world/ode/joints/pushed_stops.h"

#include <algorithm>

#include "world/ode/joints/axis_motor.h"
#include "world/ode/objects/ode_math.h"

namespace trundle {

namespace {

constexpr double kParting = 1e-3; // m/s, rad/s
constexpr double kBeyond = 1e-6;  // m, rad

/// By which the position is outside; 0: it is between the two.
double outside(double position, double low, double high) {
    return position < low ? position - low : std::max(0.0, position - high);
}

/// That of a slider is in the joint itself; that of a suspension is its spring, which is stiff beyond its travel.
bool isOwn(JointType type) { return type == JointType::Slider || type == JointType::Suspension; }

void setErrorReduction(dJointID joint, JointType type, int axis, double value) {
    if (type == JointType::Slider) dJointSetSliderParam(joint, dParamStopERP, value);
    else if (type == JointType::Suspension) dJointSetHinge2Param(joint, dParamSuspensionERP, value);
    else setRow(joint, type, axis, dParamStopERP, value);
}

double errorReduction(dJointID joint, JointType type, int axis) {
    if (type == JointType::Slider) return dJointGetSliderParam(joint, dParamStopERP);
    if (type == JointType::Suspension) return dJointGetHinge2Param(joint, dParamSuspensionERP);
    return rowOf(joint, type, axis, dParamStopERP);
}

} // namespace

void PushedStops::setUp() {
    m_stopped.clear();
    for (std::uint32_t i = 0; i < m_objects.joints.size(); ++i)
        if (m_objects.joints[i].stop || m_objects.joints[i].travel > 0) m_stopped.push_back(i);
}

PushedStops::Beyond PushedStops::beyond(const OdeJoint& joint, int axis) const {
    const bool isSuspension = joint.type == JointType::Suspension;
    const double over = isSuspension ? joint.beyond
                        : axis == 0  ? outside(joint.position, joint.lowStop, joint.highStop)
                                     : outside(joint.position2, joint.lowStop2, joint.highStop2);
    if (std::abs(over) < kBeyond) return {0, 0};
    const OdeBody& c = m_objects.bodies[joint.child];
    const OdeBody* p = joint.parent == kNone ? nullptr : &m_objects.bodies[joint.parent];
    const Vec3 spin = p ? Vec3(vec(c.w) - vec(p->w)) : vec(c.w);
    if (axis == 1) return {over, spin.dot(turn(c.r, joint.secondAxis))};
    if (joint.type == JointType::Ball) {
        const Vec3 parent = p ? turn(p->r, joint.parentAxis) : joint.parentAxis;
        return {over, spin.dot(parent.cross(turn(c.r, joint.childAxis)).normalized())};
    }
    const Vec3 own = isSuspension ? joint.slideAxis : joint.parentAxis, way = p ? turn(p->r, own) : own;
    if (!isOwn(joint.type)) return {over, spin.dot(way)};
    const Vec3 lever = turn(c.r, joint.childAnchor), speed = vec(c.v) + vec(c.w).cross(lever);
    if (!p) return {over, way.dot(speed)};
    return {over, way.dot(Vec3(speed - vec(p->v) - vec(p->w).cross(vec(c.p) + lever - vec(p->p))))};
}

std::span<const std::uint32_t> PushedStops::find() {
    m_bodies.clear();
    for (const std::uint32_t index : m_stopped) {
        const OdeJoint& joint = m_objects.joints[index];
        for (int axis = 0; axis < (joint.type == JointType::Universal ? 2 : 1); ++axis) {
            const Beyond b = beyond(joint, axis);
            if (b.over == 0 || (b.over > 0 ? -b.rate : b.rate) < kParting) continue;
            hold(joint, axis);
            m_bodies.push_back(joint.child);
        }
    }
    return m_bodies;
}

void PushedStops::hold(const OdeJoint& joint, int axis) {
    const dJointID id = isOwn(joint.type) ? joint.id : joint.stop;
    m_held.push_back({id, joint.type, axis, errorReduction(id, joint.type, axis)});
    setErrorReduction(id, joint.type, axis, 0);
}

void PushedStops::release() {
    for (const Held& h : m_held) setErrorReduction(h.joint, h.type, h.axis, h.errorReduction);
    m_held.clear();
}

} // namespace trundle
