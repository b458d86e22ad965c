#include "world/ode/solver/solver_plan.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "world/ode/objects/ode_math.h"

namespace trundle {

namespace {

constexpr std::uint32_t kTriedClusterMax = 300; // contacts: a tick of so many takes some ten milliseconds
constexpr std::uint32_t kSweptClusterMax = 600; // with more the matrix would take most of the time
// Multiplications: in a tick on the average, measured as some 15 ms, in which 70 crates in stacks are solved, but not 60 balls in a heap;
// and what may be owed, as the first ticks of a wall take more.
constexpr std::uint64_t kWorkOfTick = 200'000'000, kMostOwed = 20 * kWorkOfTick;
constexpr std::uint32_t kFewRobots = 3;    // may grip and lift each other: only what stands is pushed in the plane
constexpr double kUpright = 0.7;           // cosine between a contact's normal and the vertical: it carries
constexpr double kSideways = 0.3;          // it pushes aside
constexpr double kSidewaysOfRobots = 0.75; // between robots, whose bumpers and tyres would lift each other

bool isLarge(const BodyClusters& clusters, std::uint32_t cluster) {
    return clusters.contacts(cluster) > kExactClusterMax || clusters.robots(cluster) > 1;
}

} // namespace

void SolverPlan::make(SolverChoice choice, const Vec3& up, std::span<OdeContact> contacts, std::span<const OdeGeom> geoms) {
    m_iterated.clear();
    m_piles.clear();
    ++m_tick;
    m_hasOutside = m_found = false;
    m_largest = 0;
    if (choice == SolverChoice::Quick) return;
    if (std::none_of(contacts.begin(), contacts.end(), [](const OdeContact& c) { return c.partner != kNoActor; })) return;
    findClusters(contacts, geoms);
    if (choice == SolverChoice::Auto) {
        if (up.squaredNorm() > 0 && cut(up, contacts, geoms)) m_clusters.find(contacts, geoms);
        iterateLarge(contacts, geoms);
    }
    findLargest(contacts, geoms);
}

void SolverPlan::setUp(std::span<const OdeBody> bodies, std::span<const OdeJoint> joints, std::span<const OdeCoupling> couplings,
                       std::span<const OdeLatch> latches) {
    m_clusters.setUp(bodies, joints, couplings, latches);
    m_parents.assign(bodies.size(), kNone);
    m_hardUntil.resize(bodies.size(), 0);
    m_owed.resize(bodies.size(), 0);
    for (const OdeJoint& joint : joints) m_parents[joint.child] = joint.parent;
}

void SolverPlan::findClusters(std::span<const OdeContact> contacts, std::span<const OdeGeom> geoms) {
    if (!std::exchange(m_found, true)) m_clusters.find(contacts, geoms);
}

/// What stands on the floor moves in a plane: contacts between such groups of a large cluster need no solver of all directions.
bool SolverPlan::cut(const Vec3& up, std::span<OdeContact> contacts, std::span<const OdeGeom> geoms) {
    const auto inLarge = [&](const OdeContact& c) { return isLarge(m_clusters, m_clusters.of(geoms[c.first].body)); };
    if (std::none_of(contacts.begin(), contacts.end(), inLarge)) return false;
    const auto groupOf = [&](std::uint32_t geom) { return m_clusters.groupOf(geoms[geom].body); };
    m_stands.assign(m_clusters.bodyCount(), false);
    m_carries = m_stands;
    for (const OdeContact& c : contacts) {
        if (geoms[c.second].body != kNone || vec(c.normal).dot(up) <= kUpright) continue;
        m_stands[groupOf(c.first)] = true;
        for (std::uint32_t body = geoms[c.first].body; body != kNone && !m_carries[body]; body = m_parents[body])
            m_carries[body] = true;
    }
    const auto isArm = [&](std::uint32_t geom) { return !m_carries[geoms[geom].body] && !geoms[geom].wheel; };
    for (OdeContact& c : contacts) {
        if (geoms[c.second].body == kNone || !inLarge(c)) continue;
        const std::uint32_t first = groupOf(c.first), second = groupOf(c.second);
        const bool robots = m_clusters.isJointed(first) && m_clusters.isJointed(second);
        if (std::abs(vec(c.normal).dot(up)) > (robots ? kSidewaysOfRobots : kSideways)) continue;
        const bool few = m_clusters.robots(m_clusters.of(geoms[c.first].body)) <= kFewRobots;
        c.outside = first != second && m_stands[first] && m_stands[second] && !(few && (isArm(c.first) || isArm(c.second)));
        m_hasOutside = m_hasOutside || c.outside;
    }
    return m_hasOutside;
}

void SolverPlan::iterateLarge(std::span<OdeContact> contacts, std::span<const OdeGeom> geoms) {
    for (OdeContact& c : contacts) {
        const std::uint32_t cluster = m_clusters.of(geoms[c.first].body), count = m_clusters.contacts(cluster);
        const bool large = !c.outside && count > kExactClusterMax, pile = large && count <= kSweptClusterMax;
        c.iterated = large && !pile;
        if (large) (pile ? m_piles : m_iterated).push_back(cluster);
    }
    for (std::vector<std::uint32_t>* const names : {&m_iterated, &m_piles}) {
        std::sort(names->begin(), names->end());
        names->erase(std::unique(names->begin(), names->end()), names->end());
    }
    for (const std::uint32_t name : m_piles) m_owed[name] -= std::min(m_owed[name], kWorkOfTick);
}

bool SolverPlan::isHard(std::uint32_t pile) const {
    return m_hardUntil[pile] > m_tick || m_clusters.contacts(pile) > kTriedClusterMax;
}

void SolverPlan::charge(std::uint32_t cluster, std::uint64_t work) {
    m_owed[cluster] += work;
    if (m_owed[cluster] > kMostOwed) markHard(cluster);
}

void SolverPlan::findLargest(std::span<const OdeContact> contacts, std::span<const OdeGeom> geoms) {
    for (const OdeContact& c : contacts) {
        const std::uint32_t cluster = m_clusters.of(geoms[c.first].body);
        if (c.iterated || m_clusters.contacts(cluster) <= m_largest) continue;
        m_largest = m_clusters.contacts(cluster);
        m_largestName = cluster;
    }
}

} // namespace trundle
