#include "world/ode/contacts/impacts.h"

#include <algorithm>
#include <cmath>

#include "world/ode/objects/ode_math.h"

namespace trundle {

namespace {

constexpr double kTiny = 1e-9;  // of the energy that goes back and forth
constexpr double kLess = 0.999; // keeps an estimate on the safe side
constexpr double kStep = 0.8;   // where an estimate was too high
constexpr int kMostTries = 8;

} // namespace

void Impacts::find(std::span<OdeContact> contacts, std::span<const OdeBody> bodies, std::span<const OdeGeom> geoms,
                   std::span<const SurfaceSpec> surfaces) {
    m_struck.clear();
    m_touching.assign(bodies.size(), false);
    m_bounces = m_joined = false;
    const auto speedOf = [&](std::uint32_t body, const Vec3& point) {
        if (body == kNone) return Vec3(Vec3::Zero());
        return Vec3(vec(bodies[body].v) + vec(bodies[body].w).cross(point - vec(bodies[body].p)));
    };
    for (OdeContact& c : contacts) {
        const std::uint32_t first = geoms[c.first].body, second = geoms[c.second].body;
        const Vec3 point = vec(c.position);
        c.speed = vec(c.normal).dot(speedOf(first, point) - speedOf(second, point));
        c.restitution = std::max(surfaces[geoms[c.first].surface].restitution, surfaces[geoms[c.second].surface].restitution);
        m_touching[first] = true;
        if (second != kNone) m_touching[second] = true;
        if (!(c.speed < -kBounceSpeed)) continue;
        if (m_struck.empty()) m_struck.assign(bodies.size(), false);
        m_struck[first] = true;
        if (second != kNone) m_struck[second] = true;
    }
    if (m_struck.empty()) return;
    for (OdeContact& c : contacts) {
        const std::uint32_t second = geoms[c.second].body;
        c.bounces = c.restitution > 0 && m_struck[geoms[c.first].body] && (second == kNone || m_struck[second]);
        m_bounces = m_bounces || c.bounces;
    }
}

std::uint32_t Impacts::rootOf(std::uint32_t actor) {
    while (m_parents[actor] != actor) actor = m_parents[actor] = m_parents[m_parents[actor]];
    return actor;
}

void Impacts::join(std::span<const OdeContact> contacts, std::span<const OdeGeom> geoms, std::size_t actors) {
    m_joined = true;
    m_parents.resize(actors);
    for (std::uint32_t i = 0; i < actors; ++i) m_parents[i] = i;
    const auto unite = [this](std::uint32_t first, std::uint32_t second) {
        const std::uint32_t a = rootOf(first), b = rootOf(second);
        m_parents[std::max(a, b)] = std::min(a, b);
    };
    for (const OdeContact& c : contacts)
        if (c.partner != kNoActor) unite(c.actor, c.partner);
    for (const auto& [first, second] : m_linked) unite(first, second);
    m_clusters.assign(actors, {});
    for (const OdeContact& c : contacts) {
        Cluster& cluster = m_clusters[rootOf(c.actor)];
        cluster.bounces = cluster.bounces || c.bounces;
        cluster.driven = cluster.driven || c.outside || c.iterated || geoms[c.first].moves || geoms[c.second].moves;
    }
}

/// The work of a force is that along the mean of the velocities before and after, joints or not.
bool Impacts::needRepeat(std::span<OdeContact> contacts, std::span<const dJointFeedback> forces, std::span<const OdeBody> bodies,
                         std::span<const OdeGeom> geoms, std::span<const RawState> before) {
    if (!m_bounces) return false;
    if (!m_joined) join(contacts, geoms, bodies.back().actor + 1);
    const auto work = [&](std::uint32_t geom, const dReal* force, const dReal* torque) {
        const std::uint32_t body = geoms[geom].body;
        if (body == kNone) return 0.0;
        return vec(force).dot(vec(before[body].v) + vec(bodies[body].v)) / 2 +
               vec(torque).dot(vec(before[body].w) + vec(bodies[body].w)) / 2;
    };
    for (Cluster& cluster : m_clusters) cluster.work = cluster.size = 0;
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        Cluster& cluster = m_clusters[rootOf(contacts[i].actor)];
        const dJointFeedback& f = forces[i];
        const double first = work(contacts[i].first, f.f1, f.t1), second = work(contacts[i].second, f.f2, f.t2);
        cluster.work += first + second;
        cluster.size += std::abs(first) + std::abs(second);
    }
    bool again = false;
    for (Cluster& cluster : m_clusters) again |= cluster.bounces && !cluster.driven && reduce(cluster);
    if (again)
        for (OdeContact& c : contacts) c.restitutionShare = m_clusters[rootOf(c.actor)].share;
    return again;
}

/// First with none, then with what leaves the energy as it was, and less as long as that is too much.
bool Impacts::reduce(Cluster& c) {
    const bool rose = c.work > kTiny * c.size;
    if (c.tries == 0) c.full = c.work;
    if (c.tries == 1) c.none = c.work;
    if (c.tries != 1 && (!rose || c.share == 0)) return false;
    ++c.tries;
    if (c.tries == 2 && c.none < 0) c.share = kLess * std::sqrt(c.none / (c.none - c.full));
    else if (c.tries > 2 && c.tries < kMostTries) c.share *= kStep;
    else {
        const bool changes = c.share != 0;
        c.share = 0;
        return changes;
    }
    return true;
}

} // namespace trundle
