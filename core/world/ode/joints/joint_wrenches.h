#pragma once
// What acts across joints that are measured: the sum over all rows of a joint.

#include <memory>
#include <unordered_map>
#include <vector>

#include "world/ode/motion/pinned_bodies.h"
#include "world/ode/objects/ode_objects.h"

namespace trundle {

class JointWrenches {
public:
    explicit JointWrenches(const OdeObjects& objects) : m_objects(objects) {}

    /// Measures a joint from the next step on.
    void add(std::uint32_t joint) { m_joints.emplace(joint, Measured{}); }
    /// A torque (N m), or a force (N) of a slider, of the parent on the child about or along the axis in the next step, beside the rows.
    void give(std::uint32_t joint, double effort);
    /// Before a step, once the rows of all joints are there.
    void prepare();
    /// Of the last step, with the bodies where they were before it: of the parent on the child, about the parent's anchor.
    [[nodiscard]] JointWrench of(std::uint32_t joint, const PinnedBodies& pinned) const;

private:
    struct Measured {
        double given = 0; ///< for the next step
        // Of the last step, with the bodies where they were before it, world:
        Vec3 lever = Vec3::Zero();                        ///< of the child's mass, from the parent's anchor
        Vec3 force = Vec3::Zero(), torque = Vec3::Zero(); ///< on the child beside the rows; about its centre of mass
    };
    void prepare(const OdeJoint& joint, Measured& measured) const;

    const OdeObjects& m_objects;
    std::unordered_map<std::uint32_t, Measured> m_joints;
    std::vector<std::unique_ptr<dJointFeedback>> m_feedbacks;
};

} // namespace trundle
