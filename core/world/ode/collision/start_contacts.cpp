// Contacts of the first tick after something was placed. Method: what lies at its rest height touches with a depth of 0, or misses by a
// rounding error; without a contact it would fall through one tick and slip while it is caught. So these actors are lowered by a few
// micrometres along gravity for the search, and each contact gets its true depth back; a gap may close, but no faster than in this
// tick. Actors higher up are lowered more, so that those of a stack touch each other.
#include "world/ode/collision/contact_search.h"

#include <algorithm>
#include <cmath>

namespace trundle {

namespace {

constexpr double kReach = 1e-5;       // m
constexpr std::size_t kExpected = 4; // contacts of a body

} // namespace

void ContactSearch::findForStep(std::vector<OdeContact>& contacts) {
    while (m_known < m_objects.actors.size()) markPlaced(m_known++);
    const Vec3 down = m_settings.gravity.normalized();
    if (m_placed.empty() || down.squaredNorm() == 0) {
        find(contacts);
        m_placed.clear();
        return;
    }
    contacts.reserve(kExpected * m_objects.bodies.size()); // so that it seldom grows later
    std::vector<double> lowered(m_objects.actors.size(), 0);
    for (const std::uint32_t actor : m_placed) {
        const double height = -down.dot(vec(m_objects.bodies[m_objects.actors[actor].bodies.begin].p));
        lowered[actor] = kReach * (1.5 + height / (2 * (1 + std::abs(height)))); // whoever else there is
    }
    std::vector<Vec3> places(m_objects.bodies.size());
    for (std::uint32_t i = 0; i < m_objects.bodies.size(); ++i) {
        places[i] = vec(m_objects.bodies[i].p);
        const Vec3 to = places[i] + lowered[m_objects.bodies[i].actor] * down;
        if (lowered[m_objects.bodies[i].actor] > 0) dBodySetPosition(m_objects.bodies[i].id, to.x(), to.y(), to.z());
    }
    find(contacts);
    for (std::uint32_t i = 0; i < m_objects.bodies.size(); ++i)
        if (lowered[m_objects.bodies[i].actor] > 0)
            dBodySetPosition(m_objects.bodies[i].id, places[i].x(), places[i].y(), places[i].z());
    for (OdeContact& c : contacts) {
        const double closer = (lowered[c.actor] - (c.partner == kNoActor ? 0 : lowered[c.partner])) * -vec(c.normal).dot(down);
        const double depth = c.depth - closer;
        Vec3::Map(c.position) -= (lowered[c.actor] > 0 || c.partner == kNoActor ? lowered[c.actor] : lowered[c.partner]) * down;
        c.depth = std::max(0.0, depth);
        c.gap = std::max(0.0, -depth);
    }
    m_placed.clear();
}

} // namespace trundle
