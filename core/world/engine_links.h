#pragma once
// What an engine may have between its actors.

#include "world/engine.h"

namespace trundle {

class EngineLinks {
public:
    virtual ~EngineLinks() = default;

    // An invalid parent is the world. Points and axes are in the world, for the current poses. The joined bodies do not touch each other.
    // Only before the first step.
    [[nodiscard]] virtual Result<JointHandle> addJoint(const JointSpec& joint, BodyHandle child, BodyHandle parent) = 0;
    [[nodiscard]] virtual Result<CouplingHandle> addSpring(const SpringSpec& spring, BodyHandle child, BodyHandle parent) = 0;
    /// They pass through each other.
    virtual void separate(ActorHandle first, ActorHandle second) = 0;

    /// Holds a body rigidly to another one, an invalid one: to the world, as they are in the next step, until it is given none or one of
    /// them is moved by Engine::moveActor. `latch` is any number that the caller chose for it.
    virtual void setLatch(std::uint32_t latch, BodyHandle body, std::optional<BodyHandle> held) = 0;
    [[nodiscard]] virtual bool latchHolds(std::uint32_t latch) const = 0; ///< in the last step
    /// Force (N) and torque (N m, about its centre of mass) on the held body in the last step, world frame.
    [[nodiscard]] virtual JointWrench latchWrench(std::uint32_t latch) const = 0;
};

} // namespace trundle
