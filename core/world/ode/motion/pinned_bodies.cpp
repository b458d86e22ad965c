#include "world/ode/motion/pinned_bodies.h"

#include <algorithm>

#include "world/ode/objects/ode_math.h"

namespace trundle {

void PinnedBodies::start(std::span<const OdeBody> bodies, std::span<const OdeJoint> joints, const Vec3& gravity) {
    m_gravity = gravity;
    std::vector<std::uint32_t> uses(bodies.size(), 0);
    for (const OdeJoint& joint : joints) {
        ++uses[joint.child];
        if (joint.parent != kNone) uses[joint.parent] += 2; // never the child of the world alone
    }
    m_pinned.clear();
    for (std::uint32_t i = 0; i < joints.size(); ++i) {
        const OdeJoint& joint = joints[i];
        if (uses[joint.child] != 1 || joint.parent != kNone || bodies[joint.child].coupled) continue;
        if ((joint.type != JointType::Ball && joint.type != JointType::Hinge) || joint.spring || joint.friction ||
            (joint.type == JointType::Ball && joint.stop))
            continue;
        dMass mass;
        dBodyGetMass(bodies[joint.child].id, &mass); // with the rotors of its motors
        Pinned p;
        p.body = joint.child;
        p.joint = i;
        p.ball = joint.type == JointType::Ball;
        p.mass = mass.mass;
        p.central = matrix(mass.I);
        const Vec3& arm = joint.childAnchor;
        p.inertia = RotationalInertia(p.central + p.mass * (arm.squaredNorm() * Mat3::Identity() - arm * arm.transpose()));
        m_pinned.push_back(p);
    }
    std::sort(m_pinned.begin(), m_pinned.end(), [](const Pinned& a, const Pinned& b) { return a.body < b.body; });
}

const PinnedBodies::Pinned* PinnedBodies::find(std::uint32_t body) const {
    const auto found = std::lower_bound(m_pinned.begin(), m_pinned.end(), body,
                                        [](const Pinned& p, std::uint32_t index) { return p.body < index; });
    return found != m_pinned.end() && found->body == body ? &*found : nullptr;
}

/// Torque of gravity where the body will be in h / sqrt(12) if it starts from rest.
Vec3 PinnedBodies::gravityAhead(const Pinned& p, const Vec3& lever, const Vec3& change, double h) const {
    return (turnedBy(h * h / 12 * change) * lever).cross(p.mass * m_gravity);
}

void PinnedBodies::before(std::span<const OdeBody> bodies, std::span<const OdeJoint> joints, double h, std::span<Vec3> rates) {
    for (Pinned& p : m_pinned) {
        const OdeBody& b = bodies[p.body];
        const OdeJoint& joint = joints[p.joint];
        p.active = !joint.driven;
        p.velocity = vec(b.v);
        p.forceOfChord.setZero();
        if (!p.active) continue;
        p.pin = joint.parentAnchor; // it moves with a robot that is placed
        const Vec3 lever = -turn(b.r, joint.childAnchor);
        p.start = quat(b.q);
        if (p.ball) turnOnBall(p, b, lever, h);
        else turnOnHinge(p, b, joint.parentAxis, lever, h);
        rates[p.body] = p.mean;
    }
}

/// The torque about the pin with which the solver finds the mean rate, while the centre moves along the chord to where it will be.
Vec3 PinnedBodies::torqueFor(const Pinned& p, const OdeBody& b, const Vec3& lever, const Vec3& leverAfter, double h) const {
    const Vec3 chord = (leverAfter - lever) / h;
    return (turn(b.r, p.central * turnBack(b.r, p.mean - vec(b.w))) + p.mass * lever.cross(chord - vec(b.v))) / h;
}

void PinnedBodies::turnOnBall(Pinned& p, const OdeBody& b, const Vec3& lever, double h) {
    const Vec3 weight = lever.cross(p.mass * m_gravity);
    const Vec3 given = vec(dBodyGetTorque(b.id)) + lever.cross(vec(dBodyGetForce(b.id)));
    const Vec3 change = p.inertia.rate(p.start, weight);
    p.momentum = p.inertia.momentum(p.start, vec(b.w)) + h * (given + gravityAhead(p, lever, change, h));
    const Vec3 expected = p.inertia.rate(p.start, p.momentum);
    const Quat end = p.inertia.turnedFreely(p.start, p.momentum, h);
    p.mean = meanRate(p.start, end, h, expected);
    const Vec3 extra = torqueFor(p, b, lever, end * p.start.conjugate() * lever, h) - given - weight;
    dBodyAddTorque(b.id, extra.x(), extra.y(), extra.z());
}

void PinnedBodies::turnOnHinge(Pinned& p, const OdeBody& b, const Vec3& axis, const Vec3& lever, double h) const {
    const Vec3 weight = lever.cross(p.mass * m_gravity);
    const Vec3 given = vec(dBodyGetTorque(b.id)) + lever.cross(vec(dBodyGetForce(b.id)));
    const double moment = axis.dot(p.inertia.momentum(p.start, axis));
    const Vec3 change = axis.dot(weight) / moment * axis;
    p.mean = (axis.dot(vec(b.w)) + h / moment * axis.dot(given + gravityAhead(p, lever, change, h))) * axis;
    const Vec3 extra = axis.dot(torqueFor(p, b, lever, turnedBy(h * p.mean) * lever, h) - given - weight) * axis;
    dBodyAddTorque(b.id, extra.x(), extra.y(), extra.z());
}

Vec3 PinnedBodies::forceOfChord(std::uint32_t body) const {
    const Pinned* p = find(body);
    return p ? p->forceOfChord : Vec3(Vec3::Zero());
}

/// What the tick added to the mean rate, it added to the momentum. The change of the velocity from one tangent to the next is that of
/// the middle of the tick.
void PinnedBodies::after(std::span<const OdeBody> bodies, double h) {
    for (Pinned& p : m_pinned) {
        if (!p.active) continue;
        const OdeBody& b = bodies[p.body];
        Vec3 w = vec(b.w);
        if (p.ball) w = p.inertia.rate(quat(b.q), p.momentum + p.inertia.momentum(p.start, w - p.mean));
        const Vec3 v = w.cross(vec(b.p) - p.pin);
        const Vec3 change = v - p.velocity;
        p.forceOfChord = p.mass / h * (v - vec(b.v) + turnedBy(-0.5 * h * p.mean) * change - change);
        dBodySetAngularVel(b.id, w.x(), w.y(), w.z());
        dBodySetLinearVel(b.id, v.x(), v.y(), v.z());
    }
}

} // namespace trundle
