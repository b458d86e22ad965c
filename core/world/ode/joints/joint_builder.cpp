#include "world/ode/joints/joint_builder.h"

#include <array>
#include <cmath>

namespace trundle {

namespace {

constexpr double kLeastGapLimit = 0.005; // m

/// True if a wheel's axle passes through the centre of a sphere or along the axis of a cylinder.
bool isCoaxial(GeomShape shape, const Vec3& centre, const Vec3& cylinderAxis, double radius, const Vec3& anchor,
               const Vec3& axle) {
    const Vec3 off = centre - anchor;
    if ((off - off.dot(axle) * axle).norm() > 1e-4 * radius) return false;
    return shape == GeomShape::Sphere || (shape == GeomShape::Cylinder && cylinderAxis.cross(axle).norm() < 1e-4);
}

/// With the bodies as they are at position 0. A universal joint's Axis is fixed to the parent; Axis2 to the child, which is ODE's first
/// body.
void setFrame(const OdeJoint& joint, const JointFrame& frame) {
    const auto& [anchor, axis, axis2] = frame;
    switch (joint.type) {
    case JointType::Hinge:
        dJointSetHingeAnchor(joint.id, anchor.x(), anchor.y(), anchor.z());
        dJointSetHingeAxis(joint.id, axis.x(), axis.y(), axis.z());
        break;
    case JointType::Slider: dJointSetSliderAxis(joint.id, axis.x(), axis.y(), axis.z()); break;
    case JointType::Ball: dJointSetBallAnchor(joint.id, anchor.x(), anchor.y(), anchor.z()); break;
    case JointType::Universal:
        dJointSetUniversalAnchor(joint.id, anchor.x(), anchor.y(), anchor.z());
        dJointSetUniversalAxis1(joint.id, axis2.x(), axis2.y(), axis2.z());
        dJointSetUniversalAxis2(joint.id, axis.x(), axis.y(), axis.z());
        break;
    case JointType::Fixed: dJointSetFixed(joint.id); break;
    case JointType::Suspension: break; // see makeSuspension
    }
}

} // namespace

void JointBuilder::addJoint(const JointSpec& spec, const ActorDef& def, std::uint32_t actor) {
    const std::uint32_t first = m_objects.actors[actor].bodies.begin;
    OdeJoint joint;
    joint.order = static_cast<std::uint32_t>(m_objects.joints.size()) - m_objects.actors[actor].joints.begin;
    joint.child = first + static_cast<std::uint32_t>(spec.child);
    joint.parent = spec.parent == kWorldBody ? kNone : first + static_cast<std::uint32_t>(spec.parent);
    add(joint, spec, {def.frame * spec.anchor, def.frame.rotation * spec.axis, def.frame.rotation * spec.axis2});
}

void JointBuilder::addLink(const JointSpec& spec, std::uint32_t child, std::uint32_t parent) {
    OdeJoint joint;
    joint.order = static_cast<std::uint32_t>(m_objects.links.size());
    joint.child = child;
    joint.parent = parent;
    m_objects.links.push_back(static_cast<std::uint32_t>(m_objects.joints.size()));
    add(joint, spec, {spec.anchor, spec.axis, spec.axis2});
}

void JointBuilder::add(OdeJoint& joint, const JointSpec& spec, const JointFrame& frame) {
    joint.type = spec.type;
    joint.stiffness = spec.stiffness;
    joint.damping = spec.damping;
    joint.travel = spec.travel;
    joint.rest = spec.rest;
    joint.stiffness2 = spec.stiffness2.value_or(spec.stiffness);
    joint.damping2 = spec.damping2.value_or(spec.damping);
    const Vec3 main = spec.type == JointType::Suspension ? frame.axis2 : frame.axis;
    carryFrame(joint, frame, main);
    makeJoint(joint, spec, frame);
    if (spec.type == JointType::Hinge || spec.type == JointType::Suspension) findWheels(joint, frame.anchor, main);
    m_objects.joints.push_back(joint);
    if (joint.stiffness > 0 || joint.stiffness2 > 0)
        for (const std::uint32_t body : {joint.child, joint.parent})
            if (body != kNone) m_objects.actors[m_bodies[body].actor].sprung = true;
    m_rows.add(static_cast<std::uint32_t>(m_objects.joints.size() - 1), spec, main, frame.axis2);
}

/// Stores the joint frame relative to child and parent.
void JointBuilder::carryFrame(OdeJoint& joint, const JointFrame& frame, const Vec3& main) const {
    const OdeBody& child = m_bodies[joint.child];
    joint.childAnchor = turnBack(child.r, frame.anchor - vec(child.p));
    joint.childAxis = turnBack(child.r, main);
    joint.parentAnchor = frame.anchor;
    joint.parentAxis = main;
    joint.slideAxis = frame.axis;
    joint.secondAxis = turnBack(child.r, frame.axis2);
    joint.start = quat(child.q);
    if (joint.parent != kNone) {
        const OdeBody& parent = m_bodies[joint.parent];
        joint.parentAnchor = turnBack(parent.r, frame.anchor - vec(parent.p));
        joint.parentAxis = turnBack(parent.r, main);
        joint.slideAxis = turnBack(parent.r, frame.axis);
        joint.start = quat(parent.q).conjugate() * quat(child.q);
    }
    joint.gapLimit = std::max(2 * kLeastGapLimit, 0.1 * joint.childAnchor.norm());
}

void JointBuilder::makeJoint(OdeJoint& joint, const JointSpec& spec, const JointFrame& frame) {
    switch (spec.type) {
    case JointType::Hinge: joint.id = attached(dJointCreateHinge(m_world, nullptr), joint); break;
    case JointType::Slider: joint.id = attached(dJointCreateSlider(m_world, nullptr), joint); break;
    case JointType::Ball: joint.id = attached(dJointCreateBall(m_world, nullptr), joint); break;
    case JointType::Universal: joint.id = attached(dJointCreateUniversal(m_world, nullptr), joint); break;
    case JointType::Fixed: joint.id = attached(dJointCreateFixed(m_world, nullptr), joint); break;
    case JointType::Suspension: return makeSuspension(joint, frame.anchor, frame.axis, frame.axis2);
    }
    setFrame(joint, frame);
}

/// Attaches the child as first body, then the parent or the world.
dJointID JointBuilder::attached(dJointID id, const OdeJoint& joint) const {
    dJointAttach(id, m_bodies[joint.child].id, joint.parent == kNone ? nullptr : m_bodies[joint.parent].id);
    return id;
}

/// ODE's hinge-2 with its steering locked: the wheel rotates about axis2 and slides along axis.
void JointBuilder::makeSuspension(OdeJoint& joint, const Vec3& anchor, const Vec3& axis, const Vec3& axis2) {
    joint.id = dJointCreateHinge2(m_world, nullptr);
    dJointAttach(joint.id, m_bodies[joint.parent].id, m_bodies[joint.child].id);
    dJointSetHinge2Anchor(joint.id, anchor.x(), anchor.y(), anchor.z());
    const dReal a[4] = {axis.x(), axis.y(), axis.z(), 0}, b[4] = {axis2.x(), axis2.y(), axis2.z(), 0};
    dJointSetHinge2Axes(joint.id, a, b);
    dJointSetHinge2Param(joint.id, dParamLoStop, 0);
    dJointSetHinge2Param(joint.id, dParamHiStop, 0);
    joint.drive = axisMotor(joint, m_bodies, std::array{axis2}, false);
}

/// Marks the geoms of the child that are wheels on the axle.
void JointBuilder::findWheels(OdeJoint& joint, const Vec3& anchor, const Vec3& axle) {
    const OdeBody& body = m_bodies[joint.child];
    bool any = false;
    for (std::uint32_t i = body.geoms.begin; i < body.geoms.end; ++i) {
        OdeGeom& g = m_objects.geoms[i];
        const Vec3 centre = vec(body.p) + turn(body.r, g.offset), along = turn(body.r, g.axes.col(2));
        if ((g.shape != GeomShape::Sphere && g.shape != GeomShape::Cylinder) ||
            !isCoaxial(g.shape, centre, along, g.radius, anchor, axle))
            continue;
        g.wheel = any = true;
        g.axle = turnBack(body.r, axle);
        joint.gapLimit = g.radius / 10;
    }
    // Finite rotation keeps the hinge's angle equal to the integral of its rate.
    if (any) dBodySetFiniteRotationMode(body.id, 1);
}

/// ODE takes the place of a joint from its bodies, so the child is where it is at position 0 meanwhile.
void moveWorldJoint(OdeJoint& joint, const OdeBody& child, const Pose& motion) {
    joint.parentAnchor = motion * joint.parentAnchor;
    joint.parentAxis = (motion.rotation * joint.parentAxis).normalized();
    joint.slideAxis = joint.parentAxis; // those that may have the world as their parent slide along no other axis
    joint.start = (motion.rotation * joint.start).normalized();
    const RawState now = rawState(child);
    const Vec3 at = joint.parentAnchor - joint.start * joint.childAnchor;
    dReal q[4];
    toOde(joint.start, q);
    dBodySetPosition(child.id, at.x(), at.y(), at.z());
    dBodySetQuaternion(child.id, q);
    setFrame(joint, {joint.parentAnchor, joint.parentAxis, joint.start * joint.secondAxis});
    setRawState(child, now);
    for (const dJointID row : {joint.drive, joint.spring, joint.friction, joint.stop, joint.damper, joint.losses})
        if (row) setWorldAxes(row, joint);
}

/// Adds J a a^T to the inertia tensor about the child's centre of mass, where a is the joint axis in the child's axes: about the
/// axis it is the whole inertia, across it none.
Status addAxialInertia(const OdeJoint& joint, const OdeBody& child, double inertia) {
    if (joint.type == JointType::Slider || !(inertia >= 0) || !std::isfinite(inertia))
        return Error{Code::BadJoint, "takes no axial inertia"};
    try {
        prepareThread();
        dMass mass;
        dBodyGetMass(child.id, &mass);
        for (int row = 0; row < 3; ++row)
            for (int column = 0; column < 3; ++column)
                mass.I[4 * row + column] += inertia * joint.childAxis[row] * joint.childAxis[column];
        dBodySetMass(child.id, &mass);
    } catch (const OdeFault&) { return Error{Code::BadJoint, "takes no such axial inertia"}; }
    return {};
}

} // namespace trundle
