// Publishes the states after a step and checks that they are plausible.
#include "world/ode/ode_engine.h"

#include <cmath>
#include <cstdio>
#include <cstring>

namespace trundle {

namespace {

constexpr double kFarthest = 1e5;    // m
constexpr double kFastest = 200;     // m/s
constexpr double kFastestTurn = 1e4; // rad/s

bool within(const dReal* v, double most) { // false for NaN
    return std::abs(v[0]) <= most && std::abs(v[1]) <= most && std::abs(v[2]) <= most &&
           v[0] * v[0] + v[1] * v[1] + v[2] * v[2] <= most * most;
}

bool isFinite(const dReal* v, int count) {
    for (int i = 0; i < count; ++i)
        if (!std::isfinite(v[i])) return false;
    return true;
}

std::string text(const char* format, double value) {
    char buffer[128];
    std::snprintf(buffer, sizeof buffer, format, value);
    return buffer;
}

} // namespace

void OdeEngine::publishBody(std::uint32_t index) {
    const Body& b = m_bodies[index];
    BodyState& s = m_states[index];
    const Vec3 lever = turn(b.r, b.centre); // from the frame's origin to the centre of mass
    s.position = vec(b.p) - lever;
    s.rotation = quat(b.q);
    s.angular = vec(b.w);
    s.linear = vec(b.v) - s.angular.cross(lever);
}

void OdeEngine::publish(double h) {
    for (std::uint32_t i = 0; i < m_bodies.size(); ++i) publishBody(i);
    for (Joint& joint : m_joints) m_rows.measure(joint, h);
    m_geomContactsReady = false;
}

std::optional<EngineFault> OdeEngine::findFault() const {
    for (std::uint32_t i = 0; i < m_bodies.size(); ++i) {
        const Body& b = m_bodies[i];
        if (within(b.p, kFarthest) && within(b.v, kFastest) && within(b.w, kFastestTurn) && isFinite(b.q, 4)) continue;
        const BodyHandle id{i};
        if (!isFinite(b.p, 3) || !isFinite(b.q, 4) || !isFinite(b.v, 3) || !isFinite(b.w, 3))
            return EngineFault{id, "its state is no longer a number"};
        if (!within(b.v, kFastest))
            return EngineFault{id, text("it moves at %.3g m/s", vec(b.v).norm()) + text(", more than %g m/s", kFastest)};
        if (!within(b.w, kFastestTurn))
            return EngineFault{id, text("it turns at %.3g rad/s", vec(b.w).norm()) + text(", more than %g rad/s", kFastestTurn)};
        return EngineFault{id, text("it is farther than %g m from the origin", kFarthest)};
    }
    for (const Joint& joint : m_joints) {
        if (joint.type == JointType::Slider || joint.type == JointType::Fixed) continue;
        Vec3 gap = m_rows.anchorGap(joint);
        if (joint.type == JointType::Suspension) {
            const Vec3 axis = turn(m_bodies[joint.parent].r, joint.slideAxis);
            gap -= gap.dot(axis) * axis;
        }
        const double open = gap.norm(), slack = m_solver.isQuick(joint.child) ? 5 : 1; // it closes joint gaps over several steps
        if (open > slack * joint.gapLimit)
            return EngineFault{{joint.child}, text("its joint is torn open by %.3g mm", 1e3 * open)};
    }
    return {};
}

/// The fault of a step that ODE could not finish: names the body with an invalid state, otherwise the lightest one, which is the
/// usual cause.
EngineFault OdeEngine::interruptedFault() const {
    std::uint32_t lightest = 0;
    dReal least = HUGE_VAL;
    for (std::uint32_t i = 0; i < m_bodies.size(); ++i) {
        const Body& b = m_bodies[i];
        if (!isFinite(b.p, 3) || !isFinite(b.q, 4) || !isFinite(b.v, 3) || !isFinite(b.w, 3))
            return {{i}, "its state is no longer a number"};
        dMass mass;
        dBodyGetMass(b.id, &mass);
        if (mass.mass >= least) continue;
        least = mass.mass;
        lightest = i;
    }
    return {{lightest}, "the solver finds no valid forces for it"};
}

EngineContact OdeEngine::contact(std::size_t index) const {
    const Contact& c = m_contacts[index];
    EngineContact out{c.actor, c.partner, c.first, c.second, vec(c.position), vec(c.normal), c.depth, 0};
    out.force = vec(m_contactFeedbacks[index].f1).dot(out.normal);
    return out;
}

std::span<const std::uint32_t> OdeEngine::contactsOf(GeomHandle geom) const {
    if (!m_geomContactsReady) { // built on demand, since most worlds never need it
        m_geomContactBegin.assign(m_geoms.size() + 1, 0);
        for (const Contact& c : m_contacts) {
            ++m_geomContactBegin[c.first + 1];
            ++m_geomContactBegin[c.second + 1];
        }
        for (std::size_t i = 1; i < m_geomContactBegin.size(); ++i) m_geomContactBegin[i] += m_geomContactBegin[i - 1];
        m_geomContacts.resize(2 * m_contacts.size());
        for (std::size_t i = m_contacts.size(); i-- > 0;) {
            m_geomContacts[--m_geomContactBegin[m_contacts[i].first + 1]] = static_cast<std::uint32_t>(i);
            m_geomContacts[--m_geomContactBegin[m_contacts[i].second + 1]] = static_cast<std::uint32_t>(i);
        }
        for (std::size_t i = 0; i + 1 < m_geomContactBegin.size(); ++i) m_geomContactBegin[i] = m_geomContactBegin[i + 1];
        m_geomContactBegin.back() = static_cast<std::uint32_t>(m_geomContacts.size());
        m_geomContactsReady = true;
    }
    const std::uint32_t begin = m_geomContactBegin[geom.index], end = m_geomContactBegin[geom.index + 1];
    return {m_geomContacts.data() + begin, end - begin};
}

} // namespace trundle
