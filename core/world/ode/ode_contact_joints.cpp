// From contacts to rows: clusters, surfaces combined, springs whose behaviour does not depend on the tick.
#include "world/ode/ode_engine.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace trundle {

namespace {

constexpr double kSlipSpeed = 1e-7; // m/s: below it friction's axes are ODE's own choice
constexpr double kBounceErp = 0.2;

} // namespace

std::uint32_t OdeEngine::clusterOf(std::uint32_t actor) {
    while (m_parentOf[actor] != actor) {
        m_parentOf[actor] = m_parentOf[m_parentOf[actor]];
        actor = m_parentOf[actor];
    }
    return actor;
}

/// Contacts in the largest set of actors that touch each other, those with the ground included; which the monitor hears of.
std::size_t OdeEngine::largestCluster() {
    m_parentOf.resize(m_actors.size());
    m_clusterSize.assign(m_actors.size(), 0);
    for (std::uint32_t i = 0; i < m_actors.size(); ++i) m_parentOf[i] = i;
    for (const Contact& c : m_contacts) {
        if (c.partner == kNoActor) continue;
        const std::uint32_t a = clusterOf(c.actor), b = clusterOf(c.partner);
        m_parentOf[std::max(a, b)] = std::min(a, b);
    }
    for (const Contact& c : m_contacts) ++m_clusterSize[clusterOf(c.actor)];
    const auto largest = std::max_element(m_clusterSize.begin(), m_clusterSize.end());
    if (largest == m_clusterSize.end()) return 0;
    const Actor& actor = m_actors[static_cast<std::size_t>(largest - m_clusterSize.begin())];
    if (m_settings.calls) m_settings.calls->noteCluster(*largest, actor.bodies.begin);
    return *largest;
}

void OdeEngine::makeContactJoints(double h) {
    dContact contact;
    std::memset(&contact, 0, sizeof contact);
    m_contactFeedbacks.resize(m_contacts.size()); // the solver fills every one; they must stay where they are until it has
    for (std::size_t i = 0; i < m_contacts.size(); ++i) {
        const Contact& c = m_contacts[i];
        fillSurface(c, h, contact);
        const dJointID joint = dJointCreateContact(m_world, m_contactGroup, &contact);
        const std::uint32_t other = m_geoms[c.second].body;
        dJointAttach(joint, m_bodies[m_geoms[c.first].body].id, other == kNone ? nullptr : m_bodies[other].id);
        dJointSetFeedback(joint, &m_contactFeedbacks[i]);
    }
}

Vec3 OdeEngine::pointVelocity(const Geom& geom, const Vec3& point) const {
    if (geom.body == kNone) return Vec3::Zero();
    const Body& b = m_bodies[geom.body];
    return vec(b.v) + vec(b.w).cross(point - vec(b.p));
}

void OdeEngine::fillSurface(const Contact& c, double h, dContact& out) const {
    const Geom &g1 = m_geoms[c.first], &g2 = m_geoms[c.second];
    const SurfaceSpec &s1 = m_settings.surfaces[g1.surface], &s2 = m_settings.surfaces[g2.surface];
    dSurfaceParameters& s = out.surface;
    std::memset(&s, 0, sizeof s);
    for (int k = 0; k < 3; ++k) {
        out.geom.pos[k] = c.position[k];
        out.geom.normal[k] = c.normal[k];
    }
    out.geom.depth = c.depth;

    // The stiffer of the two actors, so that the heavier is carried; then both surfaces' give on top.
    const Actor& a1 = m_actors[c.actor];
    const Actor& a2 = c.partner == kNoActor || m_actors[c.partner].stiffness < a1.stiffness ? a1 : m_actors[c.partner];
    const double softness = s1.softness + s2.softness;
    const double kp = softness > 0 ? 1 / (1 / a2.stiffness + softness) : a2.stiffness;
    const double give = h * kp + a2.damping;
    s.mode = dContactApprox1 | dContactSoftERP | dContactSoftCFM;
    s.mu = std::min(s1.friction, s2.friction);
    s.soft_erp = h * kp / give;
    s.soft_cfm = 1 / give;

    const double restitution = std::max(s1.restitution, s2.restitution);
    const bool needsSpeed = restitution > 0 || s.mu > 0;
    if (!needsSpeed) return;
    const Vec3 point = vec(c.position), normal = vec(c.normal);
    Vec3 speed = pointVelocity(g1, point) - pointVelocity(g2, point);
    if (restitution > 0 && -normal.dot(speed) > kBounceSpeed) { // a spring would eat the bounce
        s.mode = (s.mode & ~dContactSoftCFM) | dContactBounce;
        s.soft_erp = kBounceErp;
        s.bounce = restitution;
        s.bounce_vel = kBounceSpeed;
    }
    if (!(s.mu > 0)) return;

    Vec3 belt = Vec3::Zero(); // of the second surface, as the first sees it
    if (g1.moves) belt -= axesOf(g1) * g1.surfaceVelocity;
    if (g2.moves) belt += axesOf(g2) * g2.surfaceVelocity;
    Vec3 slide = vec(c.slide);
    if (slide.squaredNorm() == 0) {
        slide = speed - belt;
        // What gravity adds in this step tells the direction of a slide that is only beginning.
        if (g2.body == kNone) slide += h * m_settings.gravity;
    }
    slide -= slide.dot(normal) * normal;
    const double length = slide.norm();
    if (length > kSlipSpeed) {
        slide /= length;
    } else {
        slide =
            std::abs(normal.x()) < 0.7 ? Vec3(Vec3::UnitX() - normal.x() * normal) : Vec3(Vec3::UnitY() - normal.y() * normal);
        slide.normalize();
    }
    s.mode |= dContactFDir1;
    for (int k = 0; k < 3; ++k) out.fdir1[k] = slide[k];
    if (g1.moves || g2.moves) {
        s.mode |= dContactMotion1 | dContactMotion2;
        s.motion1 = belt.dot(slide);
        s.motion2 = belt.dot(normal.cross(slide));
    }
    const double rolling = std::max(s1.rollingFriction, s2.rollingFriction);
    if (rolling > 0) {
        s.mode |= dContactRolling;
        s.rho = s.rho2 = rolling;
        s.rhoN = 0;
        s.mode |= dContactAxisDep;
        s.mu2 = s.mu;
    }
}

} // namespace trundle
