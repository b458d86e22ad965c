#include "world/ode/pending_writes.h"

#include "world/ode/joints/axis_motor.h"
#include "world/ode/joints/joint_builder.h"

namespace trundle {

std::span<const std::uint32_t> PendingWrites::apply(OdeObjects& objects) {
    m_moved.clear();
    for (const ActorMotion& motion : m_motions) {
        move(objects, motion);
        m_moved.push_back(motion.actor);
    }
    for (const JointTorque& torque : m_torques) addTorque(objects, torque);
    for (const BodyForce& f : m_forces)
        dBodyAddForceAtPos(objects.bodies[f.body].id, f.force.x(), f.force.y(), f.force.z(), f.point.x(), f.point.y(),
                           f.point.z());
    m_motions.clear();
    m_torques.clear();
    m_forces.clear();
    return m_moved;
}

void PendingWrites::addTorque(const OdeObjects& objects, const JointTorque& write) {
    const OdeJoint& j = objects.joints[write.joint];
    if (j.type == JointType::Slider) {
        dJointAddSliderForce(j.id, write.torque);
        return;
    }
    const OdeBody& child = objects.bodies[j.child];
    const Vec3 torque = write.torque * axisNow(j, objects.bodies);
    dBodyAddTorque(child.id, torque.x(), torque.y(), torque.z());
    if (j.parent != kNone) dBodyAddTorque(objects.bodies[j.parent].id, -torque.x(), -torque.y(), -torque.z());
}

/// What holds the actor to the world.
void PendingWrites::moveHolds(OdeObjects& objects, const OdeActor& actor, const Pose& motion) {
    for (std::uint32_t i = actor.joints.begin; i < actor.joints.end; ++i)
        if (OdeJoint& joint = objects.joints[i]; joint.parent == kNone)
            moveWorldJoint(joint, objects.bodies[joint.child], motion);
    for (std::uint32_t i = actor.couplings.begin; i < actor.couplings.end; ++i) {
        OdeCoupling& c = objects.couplings[i];
        if (c.isGear && c.common == kNone) {
            c.point = motion * c.point;
            c.line = (motion.rotation * c.line).normalized();
        }
        if (!c.isGear && c.second == kNone) c.secondAnchor = motion * c.secondAnchor;
    }
}

void PendingWrites::move(OdeObjects& objects, const ActorMotion& write) {
    const OdeActor& actor = objects.actors[write.actor];
    moveHolds(objects, actor, write.motion);
    for (std::uint32_t i = actor.bodies.begin; i < actor.bodies.end; ++i) {
        const OdeBody& b = objects.bodies[i];
        const Vec3 position = write.motion * vec(b.p);
        dReal q[4];
        toOde((write.motion.rotation * quat(b.q)).normalized(), q);
        dBodySetPosition(b.id, position.x(), position.y(), position.z());
        dBodySetQuaternion(b.id, q);
        dBodySetLinearVel(b.id, 0, 0, 0);
        dBodySetAngularVel(b.id, 0, 0, 0);
    }
    for (std::uint32_t i = actor.joints.begin; i < actor.joints.end; ++i) objects.joints[i].rate = 0;
    for (const std::uint32_t i : objects.links)
        if (objects.bodies[objects.joints[i].child].actor == write.actor) objects.joints[i].rate = 0;
}

} // namespace trundle
