#pragma once
// What acts across joints that are measured: the sum over all rows of a joint.

#include <memory>
#include <span>
#include <vector>

#include "world/ode/objects/ode_objects.h"

namespace trundle {

class JointWrenches {
public:
    explicit JointWrenches(const OdeObjects& objects) : m_objects(objects) {}

    /// Measures a joint from the next step on.
    void add(std::uint32_t joint) { m_joints.push_back(joint); }
    /// Before a step, once the rows of all joints are there.
    void prepare();
    /// Of the last step: of the parent on the child.
    [[nodiscard]] JointWrench of(std::uint32_t joint) const;

private:
    const OdeObjects& m_objects;
    std::vector<std::uint32_t> m_joints;
    std::vector<std::unique_ptr<dJointFeedback>> m_feedbacks;
};

} // namespace trundle
