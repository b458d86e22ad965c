#pragma once
// Stops of joints that something passed within a tick, as a blow does: what they push back is moved, not thrown.

#include <cstdint>
#include <span>
#include <vector>

#include "world/ode/objects/ode_objects.h"

namespace trundle {

class PushedStops {
public:
    /// The objects outlive this.
    explicit PushedStops(const OdeObjects& objects) : m_objects(objects) {}

    /// Once bodies and joints have been added.
    void setUp();
    /// After a solution: bodies of joints that move back from beyond a stop. Until release() their stops only hold, for a solution
    /// for velocities alone.
    [[nodiscard]] std::span<const std::uint32_t> find();
    void release();

private:
    /// One axis of a joint: how far beyond a stop it was before the tick (negative: below the lower one), and its rate now.
    struct Beyond {
        double over, rate;
    };
    struct Held {
        dJointID joint;
        JointType type;
        int axis;
        double errorReduction;
    };
    [[nodiscard]] Beyond beyond(const OdeJoint& joint, int axis) const;
    void hold(const OdeJoint& joint, int axis);

    const OdeObjects& m_objects;
    std::vector<std::uint32_t> m_stopped; ///< joints with stops
    std::vector<std::uint32_t> m_bodies;
    std::vector<Held> m_held;
};

} // namespace trundle
