#pragma once
// What is between the actors of the ODE engine: joints, springs, latches, and actors that do not touch each other.

#include "world/engine_links.h"
#include "world/ode/actor_builder.h"
#include "world/ode/joints/latches.h"

namespace trundle {

class OdeLinks final : public EngineLinks {
public:
    /// All of these outlive this.
    OdeLinks(const OdeWorld& world, OdeObjects& objects, ActorBuilder& builder)
        : m_objects(objects), m_builder(builder), m_latches(world, objects) {}

    [[nodiscard]] Result<JointHandle> addJoint(const JointSpec& joint, BodyHandle child, BodyHandle parent) override;
    [[nodiscard]] Result<CouplingHandle> addSpring(const SpringSpec& spring, BodyHandle child, BodyHandle parent) override;
    void separate(ActorHandle first, ActorHandle second) override { m_objects.separateActors(first.index, second.index); }
    void setLatch(std::uint32_t latch, BodyHandle body, std::optional<BodyHandle> held) override;
    [[nodiscard]] bool latchHolds(std::uint32_t latch) const override { return m_latches.holds(latch); }
    [[nodiscard]] JointWrench latchWrench(std::uint32_t latch) const override { return m_latches.wrench(latch); }

    [[nodiscard]] Latches& latches() { return m_latches; }

private:
    OdeObjects& m_objects;
    ActorBuilder& m_builder;
    Latches m_latches;
};

} // namespace trundle
