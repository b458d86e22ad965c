#include "world/ode/joints/joint_wrenches.h"

#include <array>

#include "world/ode/objects/ode_math.h"

namespace trundle {

namespace {

std::array<dJointID, 7> rowsOf(const OdeJoint& joint) {
    return {joint.id, joint.drive, joint.spring, joint.friction, joint.stop, joint.damper, joint.losses};
}

} // namespace

void JointWrenches::prepare() {
    for (const std::uint32_t index : m_joints)
        for (const dJointID row : rowsOf(m_objects.joints[index])) {
            if (!row || dJointGetFeedback(row)) continue;
            m_feedbacks.push_back(std::make_unique<dJointFeedback>());
            *m_feedbacks.back() = {};
            dJointSetFeedback(row, m_feedbacks.back().get());
        }
}

JointWrench JointWrenches::of(std::uint32_t index) const {
    const OdeJoint& joint = m_objects.joints[index];
    const OdeBody& child = m_objects.bodies[joint.child];
    JointWrench sum;
    for (const dJointID row : rowsOf(joint)) {
        const dJointFeedback* f = row ? dJointGetFeedback(row) : nullptr;
        if (!f) continue;
        const bool first = dJointGetBody(row, 0) == child.id;
        sum.force += vec(first ? f->f1 : f->f2);
        sum.torque += vec(first ? f->t1 : f->t2);
    }
    sum.torque -= turn(child.r, joint.childAnchor).cross(sum.force); // ODE's torques are about the centre of mass
    return sum;
}

} // namespace trundle
