#include "world/ode/joints/joint_wrenches.h"

#include <utility>

#include "world/ode/joints/axis_motor.h"
#include "world/ode/objects/ode_math.h"

namespace trundle {

namespace {

/// Calls `use` for each row of a joint.
template <class Use> void eachRow(const OdeJoint& joint, const Use& use) {
    for (const dJointID row : {joint.id, joint.drive, joint.spring, joint.friction, joint.stop, joint.damper, joint.losses})
        if (row) use(row);
    for (const auto& rotor : joint.rotors) use(rotor->row);
}

} // namespace

void JointWrenches::give(std::uint32_t joint, double effort) {
    if (const auto found = m_joints.find(joint); found != m_joints.end()) found->second.given += effort;
}

void JointWrenches::prepare(const OdeJoint& joint, Measured& measured) const {
    const OdeBody& child = m_objects.bodies[joint.child];
    const OdeBody* parent = joint.parent == kNone ? nullptr : &m_objects.bodies[joint.parent];
    const Vec3 anchor = parent ? Vec3(vec(parent->p) + turn(parent->r, joint.parentAnchor)) : joint.parentAnchor;
    measured.lever = vec(child.p) - anchor;
    measured.force = joint.dampForce;
    measured.torque = turn(child.r, joint.childAnchor).cross(joint.dampForce);
    const Vec3 given = std::exchange(measured.given, 0) * axisNow(joint, m_objects.bodies);
    if (joint.type != JointType::Slider) {
        measured.torque += given;
        return;
    }
    measured.force += given;
    if (parent) measured.torque += 0.5 * (vec(parent->p) - vec(child.p)).cross(given); // ODE's place of it is between the two
}

void JointWrenches::prepare() {
    for (auto& [index, measured] : m_joints) {
        prepare(m_objects.joints[index], measured);
        eachRow(m_objects.joints[index], [this](dJointID row) {
            if (dJointFeedback* known = dJointGetFeedback(row)) {
                *known = {}; // ODE leaves it as it is where the row is off in this step
                return;
            }
            m_feedbacks.push_back(std::make_unique<dJointFeedback>());
            *m_feedbacks.back() = {};
            dJointSetFeedback(row, m_feedbacks.back().get());
        });
    }
}

JointWrench JointWrenches::of(std::uint32_t index, const PinnedBodies& pinned) const {
    const OdeJoint& joint = m_objects.joints[index];
    const auto found = m_joints.find(index);
    if (found == m_joints.end()) return {};
    const Measured& measured = found->second;
    JointWrench sum{measured.force, measured.torque};
    eachRow(joint, [&](dJointID row) {
        const dJointFeedback* f = dJointGetFeedback(row);
        if (!f) return;
        const bool first = dJointGetBody(row, 0) == m_objects.bodies[joint.child].id;
        sum.force += vec(first ? f->f1 : f->f2);
        sum.torque += vec(first ? f->t1 : f->t2);
    });
    sum.torque += measured.lever.cross(sum.force); // ODE's torques are about the centre of mass of each body
    const Vec3 chord = pinned.forceOfChord(joint.child);
    sum.force += chord;
    if (joint.type == JointType::Hinge) { // a free hinge and ball take no torque about what they are free to turn about
        const Vec3 torque = measured.lever.cross(chord);
        sum.torque += torque - joint.parentAxis.dot(torque) * joint.parentAxis;
    }
    return sum;
}

} // namespace trundle
