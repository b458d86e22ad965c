#pragma once
// Makes joints of their specs. Method: the child is ODE's first body wherever ODE allows it, so that ODE's angles and rates are those of
// the child relative to the parent. What acts along the free axes is in joint_rows.h.

#include "world/ode/joints/joint_rows.h"
#include "world/ode/objects/ode_objects.h"
#include "world/ode/objects/ode_world.h"

namespace trundle {

class JointBuilder {
public:
    /// All of these outlive this.
    JointBuilder(const OdeWorld& world, OdeObjects& objects, JointRows& rows)
        : m_world(world.id()), m_objects(objects), m_bodies(objects.bodies), m_rows(rows) {}

    /// A joint of the actor that is being built, whose bodies and geoms are there.
    void addJoint(const JointSpec& spec, const ActorDef& def, std::uint32_t actor);
    /// A joint between actors, or of one and the world (kNone).
    void addLink(const JointSpec& spec, std::uint32_t child, std::uint32_t parent);

private:
    void add(OdeJoint& joint, const JointSpec& spec, const JointFrame& frame);
    void carryFrame(OdeJoint& joint, const JointFrame& frame, const Vec3& main) const;
    void makeJoint(OdeJoint& joint, const JointSpec& spec, const JointFrame& frame);
    [[nodiscard]] dJointID attached(dJointID id, const OdeJoint& joint) const;
    void makeSuspension(OdeJoint& joint, const Vec3& anchor, const Vec3& axis, const Vec3& axis2);
    void findWheels(OdeJoint& joint, const Vec3& anchor, const Vec3& axle);

    dWorldID m_world;
    OdeObjects& m_objects;
    const std::vector<OdeBody>& m_bodies;
    JointRows& m_rows;
};

/// Moves a joint of a body and the world; the body is moved afterwards.
void moveWorldJoint(OdeJoint& joint, const OdeBody& child, const Pose& motion);
/// Adds an inertia (kg m^2) about a joint's axis to its child.
[[nodiscard]] Status addAxialInertia(const OdeJoint& joint, const OdeBody& child, double inertia);

} // namespace trundle
