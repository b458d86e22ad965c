#pragma once
// Moves the bodies by one tick, between what their contacts and joints allow: the solver, and around it what the solver does not know
// of: blows, that inertia turns with its body and joints with theirs, what each contact carried in the tick before.

#include "world/ode/contacts/contact_memory.h"
#include "world/ode/contacts/friction_cones.h"
#include "world/ode/contacts/impacts.h"
#include "world/ode/contacts/push_out.h"
#include "world/ode/joints/pushed_stops.h"
#include "world/ode/motion/body_rotation.h"
#include "world/ode/solver/cluster_solver.h"
#include "world/ode/solver/heap_forces.h"

namespace trundle {

class OdeDynamics {
public:
    /// All of these outlive this. The contacts are those of the tick: it fills their forces.
    OdeDynamics(const EngineSettings& settings, OdeWorld& world, const OdeObjects& objects, TickContacts& contacts);

    /// Once bodies and joints have been added, before anything moves.
    void prepare();
    /// What holds together has changed: prepares anew.
    void prepareAgain() { m_prepared = 0; }
    /// One tick of `h` seconds.
    void step(double h);
    /// Nothing that an actor carried is of use where it was put.
    void forget(std::uint32_t actor);

    [[nodiscard]] const BodyRotation& rotation() const { return m_rotation; }
    [[nodiscard]] const PinnedBodies& pinned() const { return m_pinned; }
    [[nodiscard]] const ClusterSolver& solver() const { return m_solver; }
    /// In contacts; counted above kExactClusterMax.
    [[nodiscard]] std::size_t largestExactCluster() const { return m_largestExactCluster; }

private:
    void solve(double h);
    void takeBack(std::span<const std::uint32_t> contacts, double h, std::span<const std::uint32_t> bodies = {});
    void followCones(double h);
    void keepVelocities(double h);
    void limitSprings(double h);
    void moveAside(double h) const;
    void recordLargest();
    void keepContacts(double h);

    const EngineSettings& m_settings;
    const OdeObjects& m_objects;
    TickContacts& m_contacts;
    ContactRows m_rows;
    ContactMemory m_memory;
    Impacts m_impacts;
    FrictionCones m_cones;
    PushOut m_pushOut;
    PushedStops m_stops;
    BodyRotation m_rotation;
    PinnedBodies m_pinned;
    JointDrift m_drift;
    SolverPlan m_plan;
    HeapForces m_heaps;
    ClusterSolver m_solver;
    std::size_t m_prepared = 0;         ///< bodies
    std::vector<std::uint32_t> m_again; ///< bodies
    std::size_t m_largestExactCluster = 0;
};

} // namespace trundle
