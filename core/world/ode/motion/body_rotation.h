#pragma once
// How bodies turn. ODE leaves out that a body's inertia turns with it (its own correction for that takes energy), so each tick adds
// it. What no joint holds turns as in theory: the solver works with the mean rate of the tick, then the rate at its end follows
// from the angular momentum. Contacts and springs come first in their tick, and free flight after them. What a joint holds has one rate for the
// whole tick, since joints hold that. How it turns in the tick depends on all that is joined to it, so its gyroscopic torque is expected from
// those of the last three ticks (Adams and Bashforth); where these differ too much, as after a blow, it is that of a body that turns by
// itself. What swivels and is knocked about would soon spin so fast that its joint tears, so there ODE's own correction, which takes
// energy, is the better one.

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "world/ode/motion/free_rotation.h"
#include "world/ode/motion/pinned_bodies.h"
#include "world/ode/objects/ode_records.h"

namespace trundle {

class BodyRotation {
public:
    /// Once all bodies and joints are there. `inertias`: by body, without the rotors that its motors add.
    void start(std::span<const OdeBody> bodies, std::span<const Mat3> inertias, std::span<const OdeJoint> joints,
               const PinnedBodies& pinned);
    /// Adds to the torques of a tick. `touching`: by body, has a contact.
    void before(std::span<const OdeBody> bodies, const std::vector<bool>& touching, double h);
    /// Once the solver has moved the bodies.
    void after(std::span<const OdeBody> bodies, double h);
    /// Turns a body back to where it was `time` after the start of the tick, if it turns freely.
    void rewind(const OdeBody& body, std::uint32_t index, double time) const;
    /// The rate of a body once it has been turned in no time. What no joint holds keeps its momentum, so that a fast top stays up;
    /// what a joint holds keeps its rate as seen from the body, and with it the energy.
    [[nodiscard]] Vec3 turnedAside(const OdeBody& body, std::uint32_t index, const Quat& turned) const;

private:
    struct Held {
        std::uint32_t body;
        bool swivels; ///< by ball and universal joints alone
        int known = -1;                ///< how many torques; -1: before the first tick
        Quat start = Quat::Identity(); ///< of the last tick
        std::array<Vec3, 3> torques{
            Vec3::Zero(), Vec3::Zero(),
            Vec3::Zero()}; ///< gyroscopic, in the last ticks, the last one first (W); those that are known

        /// Before a tick: what the torque turned out to be in the last one. `rate`: rad/s, with which it turned to `now` (W).
        void follow(const Quat& now, const Vec3& rate, const RotationalInertia& inertia, double h);
        /// The torque in this tick, if those of the last three are known and alike.
        [[nodiscard]] std::optional<Vec3> expected() const;
    };
    struct Tumbling {
        std::uint32_t body = 0;
        Quat start = Quat::Identity(); ///< of the tick
        Vec3 momentum = Vec3::Zero(), mean = Vec3::Zero();
        bool touches = false; ///< something, or is on a spring
    };
    void flyFreely(const OdeBody& body, const Tumbling& tumbling, double time) const;

    std::vector<RotationalInertia> m_inertias; ///< by body
    std::vector<bool> m_isHeld;                ///< by body: by joints
    std::vector<Held> m_held;                  ///< of these, whose moments differ
    std::vector<Tumbling> m_free;              ///< those that no joint holds, ascending
};

} // namespace trundle
