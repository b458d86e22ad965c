#pragma once
// Latches: each holds a body rigidly to another one, or to the world, while it is to.

#include <span>

#include "world/ode/objects/ode_objects.h"
#include "world/ode/objects/ode_world.h"

namespace trundle {

class Latches {
public:
    /// Both outlive this.
    Latches(const OdeWorld& world, OdeObjects& objects) : m_world(world.id()), m_objects(objects) {}

    /// From the next step on; `held`: nothing is to be held, kNone the world.
    void set(std::uint32_t number, std::uint32_t body, std::optional<std::uint32_t> held);
    /// Before a step, with the bodies where they are. True if something is held, or released, that was not before.
    [[nodiscard]] bool update();
    /// Of an actor that was put elsewhere, or has ended: released at the next update.
    void releaseActor(std::uint32_t actor);
    [[nodiscard]] JointWrench wrench(std::uint32_t number) const;
    [[nodiscard]] bool holds(std::uint32_t number) const;

private:
    [[nodiscard]] const OdeLatch* find(std::uint32_t number) const;
    [[nodiscard]] bool isOf(const OdeLatch& latch, std::uint32_t actor) const;
    void hold(OdeLatch& latch);
    void release(OdeLatch& latch);
    void markBodies();

    dWorldID m_world;
    OdeObjects& m_objects;
};

} // namespace trundle
