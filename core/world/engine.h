#pragma once
// The interface to the physics engine: actors in, ticks, states out. It exposes no type of a concrete engine, so other engines,
// several worlds and threads can be used behind it without changes elsewhere.
//
// An actor is a unit that stays together (a robot, a loose box). Actors, bodies, joints and geoms are ordered by creation; all
// processing order follows from that alone. Writes are queued and applied at the start of step(); reads use arrays published at
// its end. There are no callbacks during a step.

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <trundle/geometry.h>

#include "base/call_monitor.h"
#include "base/result.h"
#include "model/body_spec.h"
#include "model/experiment_spec.h"
#include "model/joint_spec.h"
#include "world/engine_reports.h"
#include "world/joint_constraint.h"

namespace trundle {

/// Maximum contacts per cluster for the exact solver, whose time grows excessively: above it Solver = auto uses the quick one.
inline constexpr std::size_t kExactClusterMax = 60;

struct EngineSettings {
    Vec3 gravity{0, 0, -9.81};
    std::uint64_t seed = 1;
    SolverChoice solver = SolverChoice::Auto;
    int iterations = 20;
    double errorReduction = 0.8; ///< fraction of a joint's position error corrected per step (ODE's ERP)
    std::vector<SurfaceSpec> surfaces;
    CallMonitor* calls = nullptr; ///< informed of large clusters before each step that solves them; must outlive the engine
    unsigned threads = 1;         ///< no result depends on it
};

/// A body of an actor. `pose` is the pose of the body's frame in the world; the spec is read only during the call.
struct BodyDef {
    Pose pose;
    const BodySpec* spec = nullptr;
};

/// Bodies and joints; joint anchors and axes are in the frame `frame` (a robot's config frame at its start).
struct ActorDef {
    Pose frame;
    std::vector<BodyDef> bodies;
    const std::vector<JointSpec>* joints = nullptr;
    bool selfCollision = false;
    const std::vector<SpringSpec>* springs = nullptr;
    const std::vector<GearSpec>* gears = nullptr;
    const std::vector<std::pair<int, int>>* noContact = nullptr; ///< pairs of bodies that do not touch each other
};

struct ActorHandles {
    ActorHandle actor;
    std::vector<BodyHandle> bodies;
    std::vector<JointHandle> joints;
    std::vector<CouplingHandle> couplings;      ///< the springs, then the gears
    std::vector<std::vector<GeomHandle>> geoms; ///< per body, in the order of the spec; invalid for a geom that does not collide
};

/// State of a body's frame (not of its centre of mass) in world coordinates: m, m/s of the frame's origin, rad/s.
struct BodyState {
    Vec3 position = Vec3::Zero();
    Quat rotation = Quat::Identity();
    Vec3 linear = Vec3::Zero();
    Vec3 angular = Vec3::Zero();
};

class EngineLinks;
class RayTargets;
class WorkTeam;

class Engine {
public:
    virtual ~Engine() = default;

    EngineLinks* const links = nullptr; ///< joints between actors; nullptr: this engine has none

    /// Adds the whole actor; on failure nothing is added.
    [[nodiscard]] virtual Result<ActorHandles> addActor(const ActorDef& actor) = 0;
    /// Adds a geom fixed to the world at `pose` (the spec's own pose is ignored).
    [[nodiscard]] virtual Result<GeomHandle> addStatic(const GeomSpec& geom, const Pose& pose) = 0;

    // Writes, applied in order at the start of the next step. A motor constraint stays until it is replaced, a force for one step.
    virtual void setMotor(JointHandle joint, const MotorConstraint& row) = 0;
    virtual void addJointTorque(JointHandle joint, double torque) = 0;
    virtual void addForce(BodyHandle body, const Vec3& force, const Vec3& point) = 0;
    virtual void setSurfaceVelocity(GeomHandle geom, const Vec3& velocity) = 0;  ///< in the geom's frame, until replaced
    virtual void setSurface(std::size_t surface, const SurfaceSpec& values) = 0; ///< by its index in the settings
    /// Moves a whole actor rigidly, with its own joints and springs to the world, and sets its velocities to zero; joint positions are
    /// kept.
    virtual void moveActor(ActorHandle actor, const Pose& motion) = 0;

    /// Adds an inertia (kg m^2) about a joint's axis to the child body. Only before the first step, as the next; not for sliders.
    [[nodiscard]] virtual Status addAxialInertia(JointHandle joint, double inertia) = 0;
    /// Adds a rotor (kg m^2) on the parent that turns `ratio` times as far against it as the child does, about a joint's axis.
    [[nodiscard]] virtual Status addRotor(JointHandle joint, double inertia, double ratio) = 0;
    /// Measures the wrench of a joint from the next step on.
    [[nodiscard]] virtual Status measureWrench(JointHandle joint) = 0;

    /// Updates contactCount() and contact() for the current poses without a step; the contact forces are zero.
    virtual void findContacts() = 0;

    /// One tick: queued writes, pairs, contacts, dynamics, publication.
    [[nodiscard]] virtual std::optional<EngineFault> step(double h) = 0;

    // Reads; values of the last step.
    [[nodiscard]] virtual const BodyState& state(BodyHandle body) const = 0;
    /// Zeros for a joint without a position. Not virtual: devices ask for it several times in a tick.
    [[nodiscard]] const JointReading& jointReading(JointHandle joint) const {
        static constexpr JointReading kAtStart{};
        return joint.index < m_joints.size() ? m_joints[joint.index] : kAtStart;
    }
    /// Of a joint that measureWrench was called for.
    [[nodiscard]] virtual JointWrench jointWrench(JointHandle joint) const = 0;
    [[nodiscard]] virtual CouplingState coupling(CouplingHandle coupling) const = 0;
    [[nodiscard]] virtual std::size_t contactCount() const = 0;
    [[nodiscard]] virtual EngineContact contact(std::size_t index) const = 0;
    /// Indices of the contacts of one geom, ascending. Valid until the next call of the same thread and the next step.
    [[nodiscard]] virtual std::span<const std::uint32_t> contactsOf(GeomHandle geom) const = 0;
    /// Casts rays against all geoms.
    [[nodiscard]] virtual const RayTargets& rays() const = 0;

    /// The threads of the steps, which between them may read at the same time and, where it is asked for, write to different actors.
    /// nullptr: one thread.
    [[nodiscard]] virtual WorkTeam* threads(bool write) = 0;

    [[nodiscard]] virtual EngineSolves solves() const = 0;
    [[nodiscard]] virtual EngineSweeps sweeps() const = 0;
    [[nodiscard]] virtual ActorFaultReport faults() const = 0;

protected:
    explicit Engine(EngineLinks* joints = nullptr) : links(joints) {}

    std::vector<JointReading> m_joints; ///< from the first step on; zeros for those without a position
};

/// The rigid-body engine (ODE).
[[nodiscard]] Result<std::unique_ptr<Engine>> makeOdeEngine(const EngineSettings& settings);
} // namespace trundle
