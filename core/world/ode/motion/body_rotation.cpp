#include "world/ode/motion/body_rotation.h"

#include <algorithm>
#include <cmath>

#include "world/ode/objects/ode_math.h"

namespace trundle {

namespace {

constexpr double kMoreEnergy = 1e-3; // relative: with more a body that is turned aside keeps its energy instead of its momentum
// Relative second difference of three torques: that of one that turns by .6 rad in a tick. The method diverges from .72 on.
constexpr double kAlike = 0.36;
constexpr double kSteady = 1e-10;    // relative change of the momentum in a tick, seen from the body: below it turns steadily

/// True for what is no number as well.
bool isSteady(const Vec3& rate, const Vec3& momentum, double h) {
    return !(h * h * rate.cross(momentum).squaredNorm() > kSteady * kSteady * momentum.squaredNorm());
}

/// By body: a motor turns it about a hinge, or what it is fixed to. Its position is the integral of its rate.
std::vector<bool> turnedByMotors(std::span<const OdeJoint> joints, std::size_t bodies) {
    std::vector<bool> turned(bodies, false);
    for (const OdeJoint& joint : joints)
        if (joint.type == JointType::Hinge && joint.driven) turned[joint.child] = true;
    for (bool more = true; more;) {
        more = false;
        for (const OdeJoint& joint : joints) {
            if (joint.type != JointType::Fixed || joint.parent == kNone || turned[joint.child] == turned[joint.parent]) continue;
            turned[joint.child] = turned[joint.parent] = more = true;
        }
    }
    return turned;
}

} // namespace

/// ODE keeps the rate while the inertia turns, so that the momentum changes: the torque is what would have kept it.
void BodyRotation::Held::follow(const Quat& now, const Vec3& rate, const RotationalInertia& inertia, double h) {
    if (known >= 0) torques = {(inertia.momentum(start, rate) - inertia.momentum(now, rate)) / h, torques[0], torques[1]};
    known = std::min(known + 1, 3);
    start = now;
}

std::optional<Vec3> BodyRotation::Held::expected() const {
    if (known < 3) return std::nullopt;
    const double largest = std::max({torques[0].squaredNorm(), torques[1].squaredNorm(), torques[2].squaredNorm()});
    if (!((torques[0] - 2 * torques[1] + torques[2]).squaredNorm() <= kAlike * kAlike * largest)) return std::nullopt;
    return (23 * torques[0] - 16 * torques[1] + 5 * torques[2]) / 12;
}

void BodyRotation::start(std::span<const OdeBody> bodies, std::span<const Mat3> inertias, std::span<const OdeJoint> joints,
                         const PinnedBodies& pinned) {
    m_inertias.clear();
    for (const Mat3& inertia : inertias) m_inertias.emplace_back(inertia);
    m_isHeld.assign(bodies.size(), false);
    std::vector<bool> swivels(bodies.size(), true);
    const auto hold = [&](std::uint32_t body, JointType by) {
        m_isHeld[body] = true;
        if (by != JointType::Ball && by != JointType::Universal) swivels[body] = false;
    };
    for (const OdeJoint& joint : joints) {
        hold(joint.child, joint.type);
        if (joint.parent != kNone) hold(joint.parent, joint.type);
    }
    for (std::uint32_t i = 0; i < bodies.size(); ++i)
        if (bodies[i].latched) hold(i, JointType::Fixed);
    const std::vector<bool> turned = turnedByMotors(joints, bodies.size());
    m_held.clear();
    m_free.clear();
    for (std::uint32_t i = 0; i < bodies.size(); ++i) {
        if (!m_isHeld[i] || pinned.hold(i) || turned[i])
            dBodySetFiniteRotationMode(bodies[i].id, 1); // by its whole angle, not by the tangent
        if (m_inertias[i].isRound() || pinned.turnFreely(i)) continue;
        if (m_isHeld[i]) m_held.emplace_back(Held{i, swivels[i]});
        else m_free.emplace_back().body = i;
    }
}

void BodyRotation::before(std::span<const OdeBody> bodies, const std::vector<bool>& touching, double h) {
    for (Held& held : m_held) {
        const OdeBody& b = bodies[held.body];
        const RotationalInertia& inertia = m_inertias[held.body];
        const Vec3 w = vec(b.w);
        if (held.swivels) {
            dBodySetGyroscopicMode(b.id, touching[held.body]);
            if (touching[held.body]) continue;
        }
        if (!held.swivels) held.follow(quat(b.q), w, inertia, h);
        const std::optional<Vec3> expected = held.expected();
        const Vec3 torque = expected ? *expected : turn(b.r, inertia.changeByMidpoint(turnBack(b.r, w), h)) / h;
        dBodyAddTorque(b.id, torque.x(), torque.y(), torque.z());
    }
    for (Tumbling& t : m_free) {
        const OdeBody& b = bodies[t.body];
        const RotationalInertia& inertia = m_inertias[t.body];
        const Vec3 w = vec(b.w), torque = vec(dBodyGetTorque(b.id));
        t.start = quat(b.q);
        t.touches = touching[t.body] || (b.coupled && !b.latched);
        if (t.touches) continue;
        t.mean = w;
        t.momentum = inertia.momentum(t.start, w) + h * torque;
        if (torque.squaredNorm() > 0) t.mean = inertia.rate(t.start, t.momentum);
        if (isSteady(t.mean, t.momentum, h)) continue;
        t.mean = meanRate(t.start, inertia.turnedFreely(t.start, t.momentum, h), h, t.mean);
        const Vec3 extra = inertia.momentum(t.start, t.mean - w) / h - torque;
        dBodyAddTorque(b.id, extra.x(), extra.y(), extra.z());
    }
}

/// What the tick added to the mean rate, it added to the momentum.
void BodyRotation::after(std::span<const OdeBody> bodies, double h) {
    for (Tumbling& t : m_free) {
        const OdeBody& b = bodies[t.body];
        const RotationalInertia& inertia = m_inertias[t.body];
        const Vec3 mean = vec(b.w);
        if (t.touches) t.momentum = inertia.momentum(t.start, mean);
        else t.momentum += inertia.momentum(t.start, mean - t.mean);
        if (isSteady(mean, t.momentum, h)) continue;
        if (t.touches) flyFreely(b, t, h);
        const Vec3 w = inertia.rate(quat(b.q), t.momentum);
        dBodySetAngularVel(b.id, w.x(), w.y(), w.z());
    }
}

void BodyRotation::flyFreely(const OdeBody& body, const Tumbling& t, double time) const {
    dReal q[4];
    toOde(m_inertias[t.body].turnedFreely(t.start, t.momentum, time), q);
    dBodySetQuaternion(body.id, q);
}

void BodyRotation::rewind(const OdeBody& body, std::uint32_t index, double time) const {
    const auto found =
        std::lower_bound(m_free.begin(), m_free.end(), index, [](const Tumbling& t, std::uint32_t i) { return t.body < i; });
    if (found == m_free.end() || found->body != index) return;
    flyFreely(body, *found, time);
    const Vec3 w = m_inertias[index].rate(quat(body.q), found->momentum);
    dBodySetAngularVel(body.id, w.x(), w.y(), w.z());
}

/// The same momentum may be more energy in the new place, much more where a rod is turned towards it: then it is scaled, or left.
Vec3 BodyRotation::turnedAside(const OdeBody& body, std::uint32_t index, const Quat& turned) const {
    const Vec3 w = vec(body.w);
    if (m_isHeld[index]) return turned * w;
    const RotationalInertia& inertia = m_inertias[index];
    if (inertia.isRound()) return w;
    const Vec3 momentum = inertia.momentum(quat(body.q), w), kept = inertia.rate(turned * quat(body.q), momentum);
    const double before = momentum.dot(w), after = momentum.dot(kept);
    if (after <= before) return kept;
    return after - before < kMoreEnergy * after ? Vec3(std::sqrt(before / after) * kept) : Vec3(turned * w);
}

} // namespace trundle
