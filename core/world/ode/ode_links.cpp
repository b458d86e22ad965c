#include "world/ode/ode_links.h"

namespace trundle {

Result<JointHandle> OdeLinks::addJoint(const JointSpec& joint, BodyHandle child, BodyHandle parent) {
    return m_builder.addJoint(joint, child.index, parent.index);
}

Result<CouplingHandle> OdeLinks::addSpring(const SpringSpec& spring, BodyHandle child, BodyHandle parent) {
    return m_builder.addSpring(spring, child.index, parent.index);
}

void OdeLinks::setLatch(std::uint32_t latch, BodyHandle body, std::optional<BodyHandle> held) {
    m_latches.set(latch, body.index, held ? std::optional(held->index) : std::nullopt);
}

} // namespace trundle
