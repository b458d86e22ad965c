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
#include "world/joint_constraint.h"
#include "world/rays/ray_query.h"

namespace trundle {

/// An object of the engine by its index. Nothing is removed, so a valid handle stays valid.
template <class Tag> struct Handle {
    std::uint32_t index = 0xffffffffu;
    [[nodiscard]] bool valid() const { return index != 0xffffffffu; }
    bool operator==(const Handle&) const = default;
};
using ActorHandle = Handle<struct ActorTag>;
using BodyHandle = Handle<struct BodyTag>;
using JointHandle = Handle<struct JointTag>;
using GeomHandle = Handle<struct GeomTag>;
using CouplingHandle = Handle<struct CouplingTag>;

inline constexpr std::uint32_t kNoActor = 0xffffffffu; ///< partner of a contact with a static

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
    unsigned threads = 1;         ///< that may work in step(); no result depends on it
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

/// Of a spring or gear after the last step.
struct CouplingState {
    double length = 0, rate = 0; ///< of a spring, m and m/s
    double effort = 0;           ///< of a spring N, positive where it pulls; of a gear what it does to its first joint: N m or N
};

/// Of the whole run.
struct EngineSolves {
    std::uint64_t quickTicks = 0;   ///< solved by the quick solver, whether selected or as a fallback
    std::uint64_t rescuedTicks = 0; ///< that the exact solver could not solve at the first attempt, whatever the outcome
    /// Most contacts in a cluster that the exact solver has solved because of Solver = exact; counted only above kExactClusterMax.
    std::size_t largestExactCluster = 0;
};

/// One contact of the last step, sorted by (actor, partner, geom).
struct EngineContact {
    std::uint32_t actor = 0;
    std::uint32_t partner = kNoActor;
    std::uint32_t first = 0, second = 0; ///< geom indices; `first` belongs to `actor`
    Vec3 position = Vec3::Zero();
    Vec3 normal = Vec3::UnitZ(); ///< towards `first`
    double depth = 0;
    double force = 0;             ///< N along the normal
    Vec3 friction = Vec3::Zero(); ///< N across the normal, on `first`
};

/// Why a step failed, after which the engine cannot be used any more, or why an actor ended.
struct EngineFault {
    BodyHandle body; ///< invalid if the whole world is affected
    std::string reason;
};

/// Of the whole run.
struct EngineSweeps {
    std::uint64_t bodies = 0; ///< times ticks in which one moved farther than it is thick, so that its path was searched
    /// Geoms of two actors that passed through each other within a tick; once for two actors, the first 20.
    std::span<const std::pair<std::uint32_t, std::uint32_t>> passages;
};

/// Faults of single actors.
struct ActorFaultReport {
    std::span<const EngineFault> ended;        ///< one for each that has ended, in this order: it stays there and touches nothing
    std::span<const EngineFault> closedJoints; ///< the first joint of each actor that a tick tore open and that was closed again
};

class EngineLinks;

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

    /// Adds the inertia (kg m^2) of a geared rotor about a joint's axis to the child body. Only before the first step; not for
    /// sliders.
    [[nodiscard]] virtual Status addAxialInertia(JointHandle joint, double inertia) = 0;

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
    /// Indices of the contacts of one geom, ascending. Valid until the next call and the next step.
    [[nodiscard]] virtual std::span<const std::uint32_t> contactsOf(GeomHandle geom) const = 0;
    /// Casts rays against all geoms.
    [[nodiscard]] virtual const RayTargets& rays() const = 0;

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
