#pragma once
// Needs: ODE in double precision. Assumes: a validated experiment. Method: one dWorld, contacts in a fixed order, flat arrays.
// Data: actors own runs of bodies, bodies own runs of geoms; all indices ascend with creation.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "world/broad_phase.h"
#include "world/engine.h"
#include "world/ode/body_rotation.h"
#include "world/ode/cluster_solver.h"
#include "world/ode/contact_memory.h"
#include "world/ode/friction_rows.h"
#include "world/ode/heap_forces.h"
#include "world/ode/hull_on_mesh.h"
#include "world/ode/impacts.h"
#include "world/ode/joint_drift.h"
#include "world/ode/joint_rows.h"
#include "world/ode/ode_fault.h"
#include "world/ode/ode_math.h"
#include "world/ode/ode_records.h"
#include "world/ode/ode_sweep.h"
#include "world/ode/pinned_bodies.h"
#include "world/wheel_contact.h"

namespace trundle {

class OdeEngine final : public Engine {
public:
    explicit OdeEngine(const EngineSettings& settings);
    ~OdeEngine() override;

    [[nodiscard]] Result<ActorHandles> addActor(const ActorDef& actor) override;
    [[nodiscard]] Result<GeomHandle> addStatic(const GeomSpec& geom, const Pose& pose) override;
    void setMotor(JointHandle joint, const MotorConstraint& row) override;
    void addJointTorque(JointHandle joint, double torque) override;
    void addForce(BodyHandle body, const Vec3& force, const Vec3& point) override;
    void setSurfaceVelocity(GeomHandle geom, const Vec3& velocity) override;
    void setSurface(std::size_t surface, const SurfaceSpec& values) override;
    void moveActor(ActorHandle actor, const Pose& motion) override;
    [[nodiscard]] Status addAxialInertia(JointHandle joint, double inertia) override;
    void findContacts() override;
    [[nodiscard]] std::optional<EngineFault> step(double h) override;
    [[nodiscard]] const BodyState& state(BodyHandle body) const override { return m_states[body.index]; }
    [[nodiscard]] double jointPosition(JointHandle joint) const override { return m_joints[joint.index].position; }
    [[nodiscard]] double jointRate(JointHandle joint) const override { return m_joints[joint.index].rate; }
    [[nodiscard]] double jointMotorEffort(JointHandle joint) const override { return m_joints[joint.index].effort; }
    [[nodiscard]] std::size_t contactCount() const override { return m_contacts.size(); }
    [[nodiscard]] EngineContact contact(std::size_t index) const override;
    [[nodiscard]] std::span<const std::uint32_t> contactsOf(GeomHandle geom) const override;
    [[nodiscard]] std::optional<RayHit> ray(const Vec3& origin, const Vec3& direction, double range,
                                            ActorHandle without) const override;
    [[nodiscard]] std::uint64_t quickTicks() const override { return m_solver.quickTicks(); }
    [[nodiscard]] std::uint64_t rescuedTicks() const override { return m_solver.rescuedTicks(); }
    [[nodiscard]] std::size_t largestExactCluster() const override { return m_largestExactCluster; }
    [[nodiscard]] std::uint64_t solverWarnings() const override { return m_solverWarnings; }
    [[nodiscard]] std::uint64_t sweptBodies() const override { return m_sweep.count(); }
    [[nodiscard]] std::span<const IndexPair> passages() const override { return m_sweep.passages(); }

private:
    using Body = OdeBody;
    using Geom = OdeGeom;
    using Actor = OdeActor;
    using Joint = OdeJoint;
    using Contact = OdeContact;

    // building (ode_actor.cpp, ode_joint.cpp)
    void buildActor(const ActorDef& def, ActorHandles& handles, std::string& failure);
    void addBody(const BodyDef& def, std::uint32_t actor, ActorHandles& handles, std::string& failure);
    [[nodiscard]] bool addGeom(const GeomSpec& spec, std::uint32_t body, std::string& failure);
    void addJoint(const JointSpec& spec, const ActorDef& def, std::uint32_t actor);
    void carryFrame(Joint& joint, const JointFrame& frame, const Vec3& main) const;
    void makeJoint(Joint& joint, const JointSpec& spec, const JointFrame& frame);
    [[nodiscard]] dJointID attached(dJointID id, const Joint& joint) const;
    void makeSlider(Joint& joint, const Vec3& axis);
    void makeHinge(Joint& joint, const Vec3& anchor, const Vec3& axis);
    void makeUniversal(Joint& joint, const Vec3& anchor, const Vec3& axis, const Vec3& axis2);
    void makeSuspension(Joint& joint, const Vec3& anchor, const Vec3& axis, const Vec3& axis2);
    void findWheels(Joint& joint, const Vec3& anchor, const Vec3& axle);
    void findSelfPairs(Actor& actor);
    void finishStatics();
    void finishBodies();

    // one step (ode_engine.cpp)
    void applyWrites();
    void applyTorque(const JointTorque& write);
    void applyMotion(const ActorMotion& write);
    void move(double h);
    void solve(double h);
    [[nodiscard]] SolverScene solverScene();

    // contacts (ode_collide.cpp)
    [[nodiscard]] SweepScene sweepScene();
    void placeGeoms(const Body& body);
    void updateBoxes();
    void findStepContacts(); // start_contacts.cpp
    void collide();
    void collideWithGround(std::uint32_t actor);
    void geomOnPlane(std::uint32_t geom, const GroundPlane& plane);
    void collideGeoms(std::uint32_t first, std::uint32_t second);
    void wheelAgainst(std::uint32_t wheel, std::uint32_t other, bool wheelFirst);
    void sphereOnPlane(std::uint32_t geom, const GroundPlane& plane);
    void boxOnPlane(std::uint32_t geom, const GroundPlane& plane);
    void genericContacts(std::uint32_t first, std::uint32_t second);
    [[nodiscard]] bool hullContacts(std::uint32_t first, std::uint32_t second);
    void addSpread(std::uint32_t first, std::uint32_t second, std::vector<SurfaceContact>& contacts);
    [[nodiscard]] bool hullOnMesh(std::uint32_t first, std::uint32_t second);
    [[nodiscard]] std::vector<Triangle> trianglesNear(std::uint32_t mesh, std::uint32_t hull);
    [[nodiscard]] FlatBody flatBody(std::uint32_t geom) const;
    [[nodiscard]] int mostContacts(std::uint32_t first, std::uint32_t second) const;
    Contact& addContact(std::uint32_t first, std::uint32_t second, const double* position, const double* normal, double depth);
    [[nodiscard]] WheelPose wheelPose(const Geom& geom, std::uint32_t index) const;
    [[nodiscard]] Mat3 axesOf(const Geom& geom) const;

    // contact joints (ode_contact_joints.cpp)
    void makeContactJoints(double h);
    [[nodiscard]] dJointID makeContactJoint(const Contact& contact, double h, dJointGroupID group, dJointFeedback* feedback);
    [[nodiscard]] Vec3 carriedBy(const Contact& contact) const;
    void fillSurface(const Contact& contact, double h, dContact& out) const;
    void fillSpring(const Contact& contact, double h, dContact& out) const;
    [[nodiscard]] double mobility(std::uint32_t geom, const Vec3& point, const Vec3& way) const;
    [[nodiscard]] FrictionLaw ownFriction(std::uint32_t geom, const Vec3& outward) const;
    [[nodiscard]] FrictionLaw frictionLaw(const Contact& contact) const;
    [[nodiscard]] Vec3 restAxis(const Contact& contact, const Vec3& normal, const Vec3& slip, double h) const;
    [[nodiscard]] bool restsQuietly(const Contact& contact, const FrictionLaw& law) const;
    void fillFriction(const Contact& contact, FrictionLaw law, const Vec3& speed, double h, dContact& out) const;
    void keepContacts(double h);
    [[nodiscard]] Vec3 pointVelocity(const Geom& geom, const Vec3& point) const;

    // publishing (ode_publish.cpp)
    void publish(double h);
    void publishBody(std::uint32_t body);
    [[nodiscard]] std::optional<EngineFault> findFault() const;
    [[nodiscard]] EngineFault interruptedFault() const;

    // rays (ode_ray.cpp)
    [[nodiscard]] std::optional<RayHit> rayOnGeom(std::uint32_t geom, const Vec3& origin, const Vec3& direction,
                                                  double range) const;

    EngineSettings m_settings;
    dWorldID m_world = nullptr;
    dJointGroupID m_contactGroup = nullptr;
    dGeomID m_ray = nullptr;

    std::vector<Actor> m_actors;
    std::vector<Body> m_bodies;
    std::vector<BodyState> m_states;
    std::vector<Geom> m_geoms;
    std::vector<Vec3> m_centres;             ///< of geoms, world
    std::vector<Box3> m_boxes, m_actorBoxes; ///< of geoms, of actors
    std::vector<Joint> m_joints;
    JointRows m_rows{m_bodies, m_joints};
    std::vector<GroundPlane> m_planes;
    std::vector<std::uint32_t> m_statics; ///< static geoms other than planes
    bool m_staticsDone = false, m_bodiesDone = false;

    std::vector<JointTorque> m_torques;
    std::vector<BodyForce> m_forces;
    std::vector<ActorMotion> m_motions;
    std::vector<std::uint32_t> m_placed; ///< actors placed since the last step

    StaticGrid m_grid;
    PairGrid m_pairGrid;
    std::vector<std::uint32_t> m_found, m_near;
    std::vector<IndexPair> m_pairs;
    std::vector<Contact> m_contacts;
    std::vector<dJointFeedback> m_contactFeedbacks; ///< by contact
    std::vector<dJointID> m_contactRows;            ///< by contact
    ContactMemory m_memory;
    Impacts m_impacts;
    BodyRotation m_rotation;
    PinnedBodies m_pinned;
    JointDrift m_drift;
    OdeSweep m_sweep{sweepScene()};
    SolverPlan m_plan;
    HeapForces m_heaps{m_settings};
    ClusterSolver m_solver{solverScene()};
    mutable std::vector<std::uint32_t> m_geomContactBegin, m_geomContacts;
    mutable bool m_geomContactsReady = false;

    std::uint64_t m_solverWarnings = 0;
    std::size_t m_largestExactCluster = 0;
    std::optional<EngineFault> m_fault;
};

} // namespace trundle
