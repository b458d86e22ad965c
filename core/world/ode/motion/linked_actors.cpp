#include "world/ode/motion/linked_actors.h"

#include <algorithm>
#include <numeric>

namespace trundle {

void LinkedActors::update(const OdeObjects& objects) {
    m_first.clear();
    m_jointed.resize(objects.actors.size());
    for (std::size_t i = 0; i < m_jointed.size(); ++i)
        m_jointed[i] = objects.actors[i].joints.begin != objects.actors[i].joints.end;
    for (const std::uint32_t link : objects.links) join(objects, objects.joints[link].child, objects.joints[link].parent);
    for (const OdeLatch& latch : objects.latches)
        if (latch.holds) join(objects, latch.body, latch.held);
    numberGroups();
}

/// `other`: kNone is the world.
void LinkedActors::join(const OdeObjects& objects, std::uint32_t body, std::uint32_t other) {
    const bool isWorld = other == kNone || dBodyIsKinematic(objects.bodies[other].id);
    std::uint32_t first = objects.bodies[body].actor, second = isWorld ? first : objects.bodies[other].actor;
    if (objects.actors[first].ended || (other != kNone && objects.actors[objects.bodies[other].actor].ended)) return;
    m_jointed[first] = m_jointed[second] = true;
    if (first == second) return;
    if (m_first.empty()) {
        m_first.resize(objects.actors.size());
        std::iota(m_first.begin(), m_first.end(), 0u);
    }
    while (m_first[first] != first) first = m_first[first];
    while (m_first[second] != second) second = m_first[second];
    m_first[std::max(first, second)] = std::min(first, second);
}

void LinkedActors::numberGroups() {
    m_next.assign(m_first.size(), kNone);
    m_last.resize(m_first.size());
    for (std::uint32_t i = 0; i < m_first.size(); ++i) {
        const std::uint32_t first = m_first[i] = m_first[m_first[i]]; // names ascend, so one step does
        if (first != i) m_next[m_last[first]] = i;
        m_last[first] = i;
    }
}

} // namespace trundle
