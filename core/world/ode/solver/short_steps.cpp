#include "world/ode/solver/short_steps.h"
#include "world/ode/joints/axis_motor.h"

#include <algorithm>

#include "world/ode/objects/ode_math.h"

namespace trundle {

namespace {

constexpr int kShortSteps = 8; // measured: a stack of ten boxes stands with 4

bool isIn(std::span<const std::uint32_t> bodies, std::uint32_t body) { return std::ranges::binary_search(bodies, body); }

} // namespace

ShortSteps::ShortSteps(OdeWorld& world, const OdeObjects& objects, TickContacts& contacts, const ContactRows& rows)
    : m_world(world), m_objects(objects), m_contacts(contacts), m_rows(rows), m_group(dJointGroupCreate(0)) {}

void ShortSteps::run(double h, std::span<const std::uint32_t> bodies, std::span<const RawState> saved) {
    prepare(bodies);
    for (const std::uint32_t body : bodies) dBodyEnable(m_objects.bodies[body].id);
    m_world.useOneThread(true); // its random numbers are of the thread
    for (int k = 0; k < kShortSteps; ++k) step(h / kShortSteps, bodies, saved);
    m_world.useOneThread(false);
    for (const std::uint32_t body : bodies) dBodyDisable(m_objects.bodies[body].id);
}

/// Contacts change from step to step, for the next tick they start as found; springs and stops are for the whole tick.
void ShortSteps::prepare(std::span<const std::uint32_t> bodies) {
    m_which.clear();
    for (std::size_t i = 0; i < m_contacts.all.size(); ++i)
        if (!m_contacts.all[i].outside && isIn(bodies, m_objects.geoms[m_contacts.all[i].first].body)) m_which.push_back(i);
    for (const OdeJoint& joint : m_objects.joints) {
        if (!isIn(bodies, joint.child)) continue;
        scaleStops(joint, 1.0 / kShortSteps);
        if (joint.type == JointType::Suspension)
            dJointSetHinge2Param(joint.id, dParamSuspensionERP,
                                 dJointGetHinge2Param(joint.id, dParamSuspensionERP) / kShortSteps);
    }
    for (const OdeCoupling& coupling : m_objects.couplings)
        if (isIn(bodies, coupling.first) && !coupling.isTorque)
            dJointSetDBallDistance(coupling.id, OdeCoupling::kApart + coupling.shift / kShortSteps);
    m_moved.clear();
    for (const std::size_t i : m_which) {
        m_contacts.feedbacks[i] = {};
        if (m_contacts.rows[i]) dJointDisable(m_contacts.rows[i]);
        m_moved.push_back(m_contacts.all[i]);
    }
    m_felt.assign(m_which.size(), {});
}

void ShortSteps::step(double part, std::span<const std::uint32_t> bodies, std::span<const RawState> saved) {
    for (std::size_t i = 0; i < m_which.size(); ++i) m_rows.add(m_moved[i], part, m_group.get(), &m_felt[i]);
    for (const std::uint32_t body : bodies) {
        const RawState& s = saved[body];
        dBodySetForce(m_objects.bodies[body].id, s.force[0], s.force[1], s.force[2]);
        dBodySetTorque(m_objects.bodies[body].id, s.torque[0], s.torque[1], s.torque[2]);
    }
    m_world.quickStep(part);
    dJointGroupEmpty(m_group.get());
    for (std::size_t i = 0; i < m_which.size(); ++i) {
        OdeContact& c = m_moved[i];
        for (int axis = 0; axis < 3; ++axis) m_contacts.feedbacks[m_which[i]].f1[axis] += m_felt[i].f1[axis] / kShortSteps;
        c.depth -= part * vec(c.normal).dot(m_objects.contactSpeed(c));
        Vec3::Map(c.position) += part * m_objects.carriedBy(c);
    }
}

} // namespace trundle
