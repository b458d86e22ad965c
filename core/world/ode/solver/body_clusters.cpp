#include "world/ode/solver/body_clusters.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace trundle {

std::uint32_t BodyClusters::root(std::uint32_t body) {
    while (m_cluster[body] != body) body = m_cluster[body] = m_cluster[m_cluster[body]];
    return body;
}

/// The lower index becomes the name.
void BodyClusters::join(std::uint32_t first, std::uint32_t second) {
    const std::uint32_t a = root(first), b = root(second);
    m_cluster[std::max(a, b)] = std::min(a, b);
}

void BodyClusters::setUp(std::span<const OdeBody> bodies, std::span<const OdeJoint> joints,
                         std::span<const OdeCoupling> couplings, std::span<const OdeLatch> latches) {
    m_cluster.resize(bodies.size());
    std::iota(m_cluster.begin(), m_cluster.end(), 0u);
    for (const OdeJoint& joint : joints)
        if (joint.parent != kNone) join(joint.child, joint.parent);
    for (const OdeCoupling& coupling : couplings)
        if (coupling.second != kNone) join(coupling.first, coupling.second);
    for (const OdeLatch& latch : latches)
        if (latch.holds && latch.held != kNone) join(latch.body, latch.held);
    m_groups.clear();
    m_jointed.assign(bodies.size(), false);
    for (std::uint32_t i = 0; i < bodies.size(); ++i) {
        m_cluster[i] = root(i);
        if (m_cluster[i] == i) m_groups.push_back(i);
    }
    for (const OdeJoint& joint : joints) m_jointed[m_cluster[joint.child]] = true;
    for (const OdeCoupling& coupling : couplings) m_jointed[m_cluster[coupling.first]] = true;
    m_group = m_cluster;
    m_contacts.assign(bodies.size(), 0);
    m_robots = m_contacts;
}

void BodyClusters::find(std::span<const OdeContact> contacts, std::span<const OdeGeom> geoms) {
    m_sorted = false;
    m_cluster = m_group;
    for (const OdeContact& c : contacts)
        if (!c.outside && geoms[c.second].body != kNone) join(geoms[c.first].body, geoms[c.second].body);
    for (std::uint32_t i = 0; i < m_cluster.size(); ++i) m_cluster[i] = m_cluster[m_cluster[i]]; // names ascend, so one step does
    std::fill(m_contacts.begin(), m_contacts.end(), 0);
    std::fill(m_robots.begin(), m_robots.end(), 0);
    for (const OdeContact& c : contacts)
        if (!c.outside) ++m_contacts[m_cluster[geoms[c.first].body]];
    for (const std::uint32_t group : m_groups) m_robots[m_cluster[group]] += m_jointed[group];
}

void BodyClusters::sortBodies() {
    if (std::exchange(m_sorted, true)) return;
    m_names.clear();
    m_begin.assign(m_cluster.size() + 1, 0);
    for (std::uint32_t i = 0; i < m_cluster.size(); ++i) {
        if (m_cluster[i] == i) m_names.push_back(i);
        ++m_begin[m_cluster[i] + 1];
    }
    std::partial_sum(m_begin.begin(), m_begin.end(), m_begin.begin());
    m_sortedBodies.resize(m_cluster.size());
    m_next.assign(m_begin.begin(), m_begin.end() - 1);
    for (std::uint32_t i = 0; i < m_cluster.size(); ++i) m_sortedBodies[m_next[m_cluster[i]]++] = i;
}

std::span<const std::uint32_t> BodyClusters::bodies(std::uint32_t cluster) {
    sortBodies();
    return std::span(m_sortedBodies).subspan(m_begin[cluster], m_begin[cluster + 1] - m_begin[cluster]);
}

std::span<const std::uint32_t> BodyClusters::all() {
    sortBodies();
    return m_names;
}

} // namespace trundle
