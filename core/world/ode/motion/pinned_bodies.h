#pragma once
// Bodies whose one joint pins a point of them to the world: pendulums and tops. Method: they turn about that point as a free body
// does about its centre, and what gravity adds each tick is taken a little ahead of where they are, which makes their period exact
// to fourth order (Takahashi and Imada).

#include <span>
#include <vector>

#include "world/ode/motion/free_rotation.h"
#include "world/ode/objects/ode_records.h"

namespace trundle {

class PinnedBodies {
public:
    /// Once all bodies and joints are there.
    void start(std::span<const OdeBody> bodies, std::span<const OdeJoint> joints, const Vec3& gravity);
    /// Before the solver: adds to the torques, and sets the rates at which these bodies will turn.
    void before(std::span<const OdeBody> bodies, std::span<const OdeJoint> joints, double h, std::span<Vec3> rates);
    /// Once the solver has moved the bodies.
    void after(std::span<const OdeBody> bodies, double h);
    /// What the joint did to the body in the last tick beside what its rows did, which move the body along a chord: a force at the
    /// pin, N, with the body where it was before the tick. Zero for other bodies.
    [[nodiscard]] Vec3 forceOfChord(std::uint32_t body) const;
    [[nodiscard]] bool hold(std::uint32_t body) const { return find(body) != nullptr; }
    /// Its rate at the end of a tick follows from its angular momentum.
    [[nodiscard]] bool turnFreely(std::uint32_t body) const { return find(body) && find(body)->ball; }

private:
    struct Pinned {
        std::uint32_t body = 0, joint = 0;
        bool ball = false, active = false;
        double mass = 0;
        Vec3 pin = Vec3::Zero(); ///< world
        Mat3 central = Mat3::Identity();
        RotationalInertia inertia; ///< about the pin
        Quat start = Quat::Identity();
        Vec3 momentum = Vec3::Zero(), mean = Vec3::Zero();
        Vec3 velocity = Vec3::Zero(), forceOfChord = Vec3::Zero(); ///< velocity: of its centre, before the tick
    };
    [[nodiscard]] const Pinned* find(std::uint32_t body) const;
    [[nodiscard]] Vec3 gravityAhead(const Pinned& p, const Vec3& lever, const Vec3& change, double h) const;
    [[nodiscard]] Vec3 torqueFor(const Pinned& p, const OdeBody& body, const Vec3& lever, const Vec3& leverAfter, double h) const;
    void turnOnBall(Pinned& p, const OdeBody& body, const Vec3& lever, double h);
    void turnOnHinge(Pinned& p, const OdeBody& body, const Vec3& axis, const Vec3& lever, double h) const;

    Vec3 m_gravity = Vec3::Zero();
    std::vector<Pinned> m_pinned; ///< ascending by body
};

} // namespace trundle
