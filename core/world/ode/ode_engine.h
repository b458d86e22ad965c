#pragma once
// The Engine on ODE in double precision. Assumes: a validated experiment. This class has the order of a step and what is read after it;
// the work is done by its parts, which share the objects and the contacts of the tick:
//
//   builders ──► OdeObjects ──► ContactSearch ──► TickContacts ──► OdeDynamics ──► OdeSweep ──► states, faults
//   (specs)      flat arrays    GeomCollider                       JointRows, ContactRows, ClusterSolver

#include <optional>
#include <span>
#include <vector>

#include "world/ode/actor_builder.h"
#include "world/ode/actor_faults.h"
#include "world/ode/collision/contacts_by_geom.h"
#include "world/ode/collision/ode_rays.h"
#include "world/ode/joints/joint_wrenches.h"
#include "world/ode/joints/rotor_row.h"
#include "world/ode/motion/ode_sweep.h"
#include "world/ode/ode_dynamics.h"
#include "world/ode/ode_links.h"
#include "world/ode/pending_writes.h"

namespace trundle {

class OdeEngine final : public Engine {
public:
    explicit OdeEngine(EngineSettings settings) : Engine(&m_links), m_settings(std::move(settings)) {}

    [[nodiscard]] Result<ActorHandles> addActor(const ActorDef& actor) override;
    [[nodiscard]] Result<GeomHandle> addStatic(const GeomSpec& geom, const Pose& pose) override;
    void setMotor(JointHandle joint, const MotorConstraint& row) override { m_rows.setMotor(joint.index, row); }
    void addJointTorque(JointHandle joint, double torque) override {
        m_writes.addTorque(joint.index, torque);
        m_wrenches.give(joint.index, torque);
    }
    void addForce(BodyHandle body, const Vec3& force, const Vec3& at) override { m_writes.addForce(body.index, force, at); }
    void setSurfaceVelocity(GeomHandle geom, const Vec3& velocity) override;
    void setSurface(std::size_t surface, const SurfaceSpec& values) override;
    void moveActor(ActorHandle actor, const Pose& motion) override { m_writes.addMotion(actor.index, motion); }
    [[nodiscard]] Status addAxialInertia(JointHandle joint, double inertia) override;
    [[nodiscard]] Status addRotor(JointHandle joint, double inertia, double ratio) override;
    [[nodiscard]] Status measureWrench(JointHandle joint) override;
    void findContacts() override;
    [[nodiscard]] std::optional<EngineFault> step(double h) override;
    [[nodiscard]] const BodyState& state(BodyHandle body) const override { return m_objects.states[body.index]; }
    [[nodiscard]] JointWrench jointWrench(JointHandle joint) const override {
        return m_wrenches.of(joint.index, m_dynamics.pinned());
    }
    [[nodiscard]] CouplingState coupling(CouplingHandle c) const override { return m_objects.couplings[c.index].state; }
    [[nodiscard]] std::size_t contactCount() const override { return m_contacts.all.size(); }
    [[nodiscard]] EngineContact contact(std::size_t index) const override;
    [[nodiscard]] std::span<const std::uint32_t> contactsOf(GeomHandle geom) const override;
    [[nodiscard]] const RayTargets& rays() const override { return m_rays; }
    [[nodiscard]] WorkTeam* threads(bool write) override {
        return write ? nullptr : m_world.team();
    } // writes are kept in one list
    [[nodiscard]] EngineSolves solves() const override;
    [[nodiscard]] EngineSweeps sweeps() const override { return {m_sweep.count(), m_sweep.passages()}; }
    [[nodiscard]] ActorFaultReport faults() const override { return {m_faults.ended(), m_faults.closed()}; }

private:
    void applyWrites();
    void publish(double h);

    EngineSettings m_settings;
    OdeWorld m_world{m_settings}; ///< destroyed after all that is in it
    OdeObjects m_objects;
    TickContacts m_contacts;
    JointRows m_rows{m_objects.bodies, m_objects.joints};
    RotorRows m_rotors{m_objects.bodies, m_objects.joints};
    CouplingRows m_couplings{m_objects, m_rows.inertias()};
    ActorBuilder m_builder{m_settings, m_world, m_objects, m_rows, m_couplings};
    OdeLinks m_links{m_world, m_objects, m_builder};
    JointWrenches m_wrenches{m_objects};
    PendingWrites m_writes;
    GeomCollider m_collider{m_objects};
    ContactSearch m_search{m_settings, m_objects, m_collider};
    OdeDynamics m_dynamics{m_settings, m_world, m_objects, m_contacts};
    OdeSweep m_sweep{m_settings, m_objects, m_dynamics.rotation(), m_search, m_collider};
    ActorFaults m_faults{m_objects, m_rows, m_dynamics.solver()};
    OdeRays m_rays{m_objects};
    mutable ContactsByGeom m_byGeom;
    std::optional<EngineFault> m_fault;
};

} // namespace trundle
