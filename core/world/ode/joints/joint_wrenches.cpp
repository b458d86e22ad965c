#include "world/ode/joints/joint_wrenches.h"

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

void JointWrenches::prepare() {
    for (const std::uint32_t index : m_joints)
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

JointWrench JointWrenches::of(std::uint32_t index) const {
    const OdeJoint& joint = m_objects.joints[index];
    const Vec3 centre = vec(m_objects.bodies[joint.child].p);
    JointWrench sum;
    eachRow(joint, [&](dJointID row) {
        const dJointFeedback* f = dJointGetFeedback(row);
        if (!f) return;
        const bool first = dJointGetBody(row, 0) == m_objects.bodies[joint.child].id;
        sum.force += vec(first ? f->f1 : f->f2);
        sum.torque += vec(first ? f->t1 : f->t2);
    });
    sum.force += joint.dampForce; // beside the rows
    sum.torque += turn(m_objects.bodies[joint.child].r, joint.childAnchor).cross(joint.dampForce);
    // ODE's torques are about the centre of mass of each body. The parent's anchor is the one that jointAnchor gives.
    Vec3 anchor = joint.parentAnchor;
    if (joint.parent != kNone) {
        const OdeBody& parent = m_objects.bodies[joint.parent];
        anchor = vec(parent.p) + turn(parent.r, joint.parentAnchor);
    }
    sum.torque += (centre - anchor).cross(sum.force);
    return sum;
}

} // namespace trundle
