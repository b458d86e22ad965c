#pragma once
// The Engine for robots on wheels, boxes, cylinders and balls on level ground (Engine = wheeled).
//
// Method: a robot is one rigid body and the spin of each wheel (vehicle_rows.h); what is loose slides or rolls over the ground; both meet
// each other and the scenery as convex footprints with heights (unit_contacts.h), and what touches is solved together (island_solver.h).
// Neglected: forces upwards between bodies, tipping of what is loose, gyroscopic moments, restitution of the ground.
// Same bits on any processor: no library function but sqrt is called in a step, and work is ordered by units.
//
//   ActorReader ──► WheeledObjects ──► UnitContacts ──► IslandSolver ──► publishStates ──► states, ContactList, WheeledRays
//   (specs)         flat arrays        what touches     motion           of bodies

#include "world/wheeled/contact_list.h"
#include "world/wheeled/island_solver.h"
#include "world/wheeled/wheeled_rays.h"

namespace trundle {

class WheeledEngine final : public Engine {
public:
    WheeledEngine(EngineSettings settings, bool planar, std::optional<double> ground);

    [[nodiscard]] Result<ActorHandles> addActor(const ActorDef& actor) override;
    [[nodiscard]] Result<GeomHandle> addStatic(const GeomSpec& geom, const Pose& pose) override;
    void setMotor(JointHandle joint, const MotorConstraint& row) override;
    void addJointTorque(JointHandle joint, double torque) override;
    void addForce(BodyHandle body, const Vec3& force, const Vec3& point) override;
    void setSurfaceVelocity(GeomHandle geom, const Vec3& velocity) override;
    void setSurface(std::size_t surface, const SurfaceSpec& values) override;
    void moveActor(ActorHandle actor, const Pose& motion) override { m_motions.push_back({actor.index, motion}); }
    [[nodiscard]] Status addAxialInertia(JointHandle joint, double inertia) override { return addRotor(joint, inertia, 1); }
    [[nodiscard]] Status addRotor(JointHandle joint, double inertia, double ratio) override;
    [[nodiscard]] Status measureWrench(JointHandle joint) override;
    void findContacts() override;
    [[nodiscard]] std::optional<EngineFault> step(double h) override;
    [[nodiscard]] const BodyState& state(BodyHandle body) const override { return m_objects.states[body.index]; }
    [[nodiscard]] JointWrench jointWrench(JointHandle) const override { return {}; }   // it measures none
    [[nodiscard]] CouplingState coupling(CouplingHandle) const override { return {}; } // it has none
    [[nodiscard]] std::size_t contactCount() const override { return m_list.all().size(); }
    [[nodiscard]] EngineContact contact(std::size_t index) const override { return m_list.at(static_cast<std::uint32_t>(index)); }
    [[nodiscard]] std::span<const std::uint32_t> contactsOf(GeomHandle geom) const override { return m_list.of(geom.index); }
    [[nodiscard]] const RayTargets& rays() const override { return m_rays; }
    [[nodiscard]] WorkTeam* threads(bool) override { return &m_team; }
    [[nodiscard]] EngineSolves solves() const override { return {}; }
    [[nodiscard]] EngineSweeps sweeps() const override { return {}; }
    [[nodiscard]] ActorFaultReport faults() const override { return {m_ended, {}}; }

private:
    struct Motion {
        std::uint32_t unit = 0;
        Pose motion;
    };
    [[nodiscard]] std::shared_ptr<const ActorShape> shapeOf(const ActorDef& actor, NotWheeled& why);
    [[nodiscard]] ActorHandles addUnit(const ActorDef& actor, std::shared_ptr<const ActorShape> shape);
    void addGeoms(const ActorDef& actor, ActorHandles& handles);
    void markAloft(const WheeledUnit& unit);
    void addWheels(const ActorDef& actor, ActorHandles& handles);
    void applyMotions();
    [[nodiscard]] bool finish(std::uint32_t index, double h);
    void endFaulty(double h);
    void publishJoints(const WheeledUnit& unit, double h);
    [[nodiscard]] std::string_view faultOf(const WheeledUnit& unit) const;
    [[nodiscard]] bool isOverGround(const WheeledUnit& unit) const;
    void setDown(WheeledUnit& unit) const;

    /// Actors with the same bodies and joints at the same height share a shape.
    struct KnownShape {
        const void *bodies = nullptr, *joints = nullptr;
        double height = 0;
        std::shared_ptr<const ActorShape> shape;
    };

    EngineSettings m_settings;
    std::optional<double> m_groundHeight; ///< m
    WheeledObjects m_objects;
    GroundSearch m_grounds;
    std::vector<KnownShape> m_shapes;
    std::vector<Motion> m_motions;
    WorkTeam m_team;
    UnitContacts m_contacts{m_objects, m_team};
    IslandSolver m_solver{m_objects, m_contacts, m_team};
    ContactList m_list{m_objects, m_contacts};
    WheeledRays m_rays{m_objects};
    std::vector<std::vector<std::uint32_t>> m_faulty; ///< units, by thread
    std::vector<EngineFault> m_ended;
    std::optional<EngineFault> m_fault;
};

} // namespace trundle
