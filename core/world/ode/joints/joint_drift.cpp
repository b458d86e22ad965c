#include "world/ode/joints/joint_drift.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "world/ode/motion/free_rotation.h"
#include "world/ode/objects/ode_math.h"

namespace trundle {

namespace {

constexpr double kLeastGain = 0.05; // with less the bodies would have to stand too far aside
constexpr double kSmall = 0.05;     // rad in a tick: a series does

/// m/s: the mean velocity of an anchor in a tick, less that at its start.
Vec3 bend(const Vec3& rate, const Vec3& arm, double h, bool whole) {
    const Vec3 along = rate.cross(arm), inward = h / 2 * rate.cross(along);
    const double turned = h * rate.norm(), t2 = turned * turned;
    if (turned < kSmall && whole) return (1 - t2 / 12) * inward - t2 / 6 * (1 - t2 / 20) * along;
    if (turned < kSmall) return (1 - t2 / 4) * inward - t2 / 4 * (1 - t2 / 4) * along; // 1 / (1 + t2 / 4)
    const double angle = whole ? turned : 2 * std::atan(turned / 2);
    return (turnedBy(angle / turned * h * rate) * arm - arm) / h - along;
}

bool pins(JointType type) { return type != JointType::Slider && type != JointType::Suspension; }

/// Without the setter of ODE, which would mark all geoms as moved.
void move(const OdeBody& body, const Vec3& by) { Eigen::Map<Vec3>(const_cast<dReal*>(body.p)) += by; }

} // namespace

void JointDrift::setUp(std::span<const OdeBody> bodies, std::span<const OdeJoint> joints) {
    if (m_last.size() != bodies.size()) m_last.assign(bodies.size(), Vec3::Zero());
    m_rates = m_last;
    m_aside.assign(bodies.size(), Vec3::Zero());
    const bool hasLinks = joinActors(bodies, joints);
    m_edges.clear();
    m_jointed.clear();
    std::vector<bool> reached(bodies.size(), false), used(joints.size(), false);
    const auto reach = [&](std::uint32_t body) {
        reached[body] = true;
        m_jointed.push_back(body);
    };
    const auto grow = [&](std::uint32_t begin, std::uint32_t end) { // a pass over the joints finds most of a tree
        for (bool more = true; more;) {
            more = false;
            for (std::uint32_t i = begin; i < end; ++i) {
                const std::uint32_t child = joints[i].child, parent = joints[i].parent;
                const bool childIn = reached[child], parentIn = parent == kNone || reached[parent];
                if (used[i] || childIn == parentIn) continue;
                used[i] = more = true;
                m_edges.push_back({i, childIn ? child : parent, childIn ? parent : child});
                reach(childIn ? parent : child);
            }
        }
    };
    const auto count = static_cast<std::uint32_t>(joints.size());
    grow(0, count); // what hangs on the world
    for (std::uint32_t i = 0; i < count; ++i) {
        const OdeJoint& joint = joints[i];
        if (reached[joint.child]) continue;
        reach(joint.parent == kNone ? joint.child : joint.parent);
        std::uint32_t end = hasLinks ? count : i + 1; // of its actor
        while (end < count && bodies[joints[end].child].actor == bodies[joint.child].actor) ++end;
        grow(i, end);
    }
    m_whole.resize(bodies.size());
    for (std::size_t i = 0; i < bodies.size(); ++i) m_whole[i] = dBodyGetFiniteRotationMode(bodies[i].id) != 0;
}

/// False if no joint is between two actors. A group has the number of its lowest actor.
bool JointDrift::joinActors(std::span<const OdeBody> bodies, std::span<const OdeJoint> joints) {
    m_groupOf.resize(bodies.empty() ? 0 : bodies.back().actor + 1);
    std::iota(m_groupOf.begin(), m_groupOf.end(), 0u);
    bool any = false;
    for (bool more = true; more;) {
        more = false;
        for (const OdeJoint& joint : joints) {
            if (joint.parent == kNone) continue;
            std::uint32_t &child = m_groupOf[bodies[joint.child].actor], &parent = m_groupOf[bodies[joint.parent].actor];
            any = any || bodies[joint.child].actor != bodies[joint.parent].actor;
            more = more || child != parent;
            child = parent = std::min(child, parent);
        }
    }
    return any;
}

std::span<Vec3> JointDrift::expectRates(std::span<const OdeBody> bodies) {
    for (const std::uint32_t i : m_jointed) {
        const Vec3 now = vec(bodies[i].w);
        m_rates[i] = 2 * now - m_last[i];
        m_last[i] = now;
    }
    return m_rates;
}

void JointDrift::start(std::span<const OdeBody> bodies, std::span<const OdeContact> contacts) {
    if (m_edges.empty()) return;
    m_touches.assign(bodies.back().actor + 1, false);
    for (const OdeContact& c : contacts) {
        m_touches[m_groupOf[c.actor]] = true;
        if (c.partner != kNoActor) m_touches[m_groupOf[c.partner]] = true;
    }
}

/// m: by how much the bodies would open a joint in this tick.
template <class RateOf> Vec3 JointDrift::gapOf(const Edge& edge, const OdeJoint& joint, double h, const RateOf& rateOf) const {
    const std::uint32_t c = joint.child, p = joint.parent;
    Vec3 gap = bend(rateOf(c), edge.childArm, h, m_whole[c]);
    if (p != kNone) gap -= bend(rateOf(p), edge.parentArm, h, m_whole[p]);
    return h * gap;
}

void JointDrift::shift(std::span<const OdeBody> bodies, std::span<const OdeJoint> joints, std::span<const OdeCoupling> couplings,
                       double h, double gain) {
    if (gain < kLeastGain) return; // no other body gives way
    for (Edge& edge : m_edges) {
        if (!dBodyIsEnabled(bodies[edge.to].id)) continue;
        const OdeJoint& joint = joints[edge.joint];
        m_aside[edge.to] = edge.from == kNone ? Vec3::Zero() : m_aside[edge.from];
        edge.closed = pins(joint.type) && !m_touches[m_groupOf[bodies[edge.to].actor]];
        if (!edge.closed) continue;
        edge.childArm = turn(bodies[joint.child].r, joint.childAnchor);
        if (joint.parent != kNone) edge.parentArm = turn(bodies[joint.parent].r, joint.parentAnchor);
        edge.gap = gapOf(edge, joint, h, [this](std::uint32_t body) { return m_rates[body]; });
        m_aside[edge.to] += (edge.to == joint.child ? 1 : -1) / gain * edge.gap;
    }
    for (const std::uint32_t i : m_jointed)
        if (!m_aside[i].isZero(0) && dBodyIsEnabled(bodies[i].id)) move(bodies[i], m_aside[i]);
    holdLevers(couplings, h, gain);
}

/// A gear's row acts along a line near its second body. If the first one is put aside of that, its lever is not that of its axle any more;
/// the rate that this would make is taken from the row, whose own correction has the same gain.
void JointDrift::holdLevers(std::span<const OdeCoupling> couplings, double h, double gain) {
    m_rows.clear();
    for (const OdeCoupling& c : couplings) {
        if (!c.isGear || c.isTorque || c.released) continue;
        const Vec3 apart = (c.second == kNone ? Vec3(Vec3::Zero()) : m_aside[c.second]) - m_aside[c.first];
        if (apart.isZero(0)) continue;
        m_rows.push_back({c.id, dJointGetDBallDistance(c.id)});
        const double rate = c.side * m_rates[c.first].dot(apart.cross(c.direction));
        dJointSetDBallDistance(c.id, m_rows.back().distance + rate * h / gain);
    }
}

void JointDrift::shiftBack(std::span<const OdeBody> bodies) {
    for (const Row& row : m_rows) dJointSetDBallDistance(row.id, row.distance);
    m_rows.clear();
    for (const std::uint32_t i : m_jointed)
        if (!m_aside[i].isZero(0) && dBodyIsEnabled(bodies[i].id)) move(bodies[i], -m_aside[i]);
}

void JointDrift::findUnexpected(std::span<const OdeBody> bodies, std::span<const OdeJoint> joints, double h,
                                std::vector<std::uint32_t>& found, double open) const {
    found.clear();
    for (const Edge& edge : m_edges) {
        if (!edge.closed) continue;
        const Vec3 gap = gapOf(edge, joints[edge.joint], h, [&](std::uint32_t body) { return vec(bodies[body].w); });
        if ((gap - edge.gap).squaredNorm() > open * open) found.push_back(edge.to);
    }
}

void JointDrift::expect(std::span<const OdeBody> bodies, std::span<const std::uint32_t> which) {
    for (const std::uint32_t i : which) m_rates[i] = vec(bodies[i].w);
}

} // namespace trundle
