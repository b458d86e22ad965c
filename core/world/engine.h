#pragma once
// The narrow border to whatever computes motion: actors in, ticks, states out. No engine's own type crosses it, so that other
// engines, more worlds and threads can stand behind it without the rest of the house noticing.
//
// An actor is what is always together (a robot, a loose box). Actors, bodies, joints and geoms are ordered by creation; that
// order alone decides every order inside. Writes are queued and applied at the start of step(); reads come from arrays
// published at its end. There is no callback while it computes.

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <trundle/geometry.h>

#include "base/call_monitor.h"
#include "base/result.h"
#include "model/body_spec.h"
#include "model/experiment_spec.h"
#include "model/joint_spec.h"

namespace trundle {

/// Index and generation: a handle of something that is gone is noticed.
template <class Tag> struct Handle {
    std::uint32_t index = 0xffffffffu;
    std::uint32_t generation = 0;
    [[nodiscard]] bool valid() const { return index != 0xffffffffu; }
    bool operator==(const Handle&) const = default;
};
using ActorHandle = Handle<struct ActorTag>;
using BodyHandle = Handle<struct BodyTag>;
using JointHandle = Handle<struct JointTag>;
using GeomHandle = Handle<struct GeomTag>;

inline constexpr std::uint32_t kNoActor = 0xffffffffu; ///< the partner of a contact with something static

/// Contacts in one cluster beyond which Solver = auto goes quick, and beyond which the exact solver's time runs away.
inline constexpr std::size_t kExactClusterMax = 60;

struct EngineSettings {
    Vec3 gravity{0, 0, -9.81};
    std::uint64_t seed = 1;
    SolverChoice solver = SolverChoice::Auto;
    int iterations = 20;
    double errorReduction = 0.8; ///< the share of what a joint gapes that one step closes (ODE's ERP)
    std::vector<SurfaceSpec> surfaces;
    CallMonitor* calls = nullptr; ///< hears of large clusters before each step that takes them on; outlives the engine
};

/// A body of an actor. `pose` is of the body's frame in the world; the spec is read during the call only.
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
};

struct ActorHandles {
    ActorHandle actor;
    std::vector<BodyHandle> bodies;
    std::vector<JointHandle> joints;
    std::vector<std::vector<GeomHandle>> geoms; ///< per body, as in the spec; invalid where a geom does not collide
};

/// State of a body's frame (not of its centre of mass): m, m/s of the origin, rad/s, world.
struct BodyState {
    Vec3 position = Vec3::Zero();
    Quat rotation = Quat::Identity();
    Vec3 linear = Vec3::Zero();
    Vec3 angular = Vec3::Zero();
};

/// A row that drives a joint to `rate` with torque (rate - actual) / softness, at most `limit`. Limit 0: no row.
struct MotorRow {
    double rate = 0;     ///< rad/s or m/s
    double softness = 0; ///< rad/s per N m; 0: as stiff as the engine allows
    double limit = 0;    ///< N m or N
};

/// One contact of the last step, sorted by (actor, partner, geom).
struct EngineContact {
    std::uint32_t actor = 0;
    std::uint32_t partner = kNoActor;
    std::uint32_t first = 0, second = 0; ///< geom indices; `first` belongs to `actor`
    Vec3 position = Vec3::Zero();
    Vec3 normal = Vec3::UnitZ(); ///< towards `first`
    double depth = 0;
    double force = 0; ///< N along the normal
};

struct RayHit {
    double distance = 0;
    Vec3 normal = Vec3::UnitZ();
    GeomHandle geom;
};

/// Why a step could not be finished. The engine is then dead.
struct EngineFault {
    BodyHandle body; ///< invalid where it is the whole world
    std::string reason;
};

class Engine {
public:
    virtual ~Engine() = default;

    /// Everything of one actor, or nothing.
    [[nodiscard]] virtual Result<ActorHandles> addActor(const ActorDef& actor) = 0;
    /// A geom fixed to the world at `pose` (the spec's own pose is not looked at).
    [[nodiscard]] virtual Result<GeomHandle> addStatic(const GeomSpec& geom, const Pose& pose) = 0;

    // Writes, applied in order at the start of the next step. A motor row stays until it is replaced, forces last one step.
    virtual void setMotor(JointHandle joint, const MotorRow& row) = 0;
    virtual void addJointTorque(JointHandle joint, double torque) = 0;
    virtual void addForce(BodyHandle body, const Vec3& force, const Vec3& point) = 0;
    virtual void setSurfaceVelocity(GeomHandle geom, const Vec3& velocity) = 0;  ///< in the geom's frame, until replaced
    virtual void setSurface(std::size_t surface, const SurfaceSpec& values) = 0; ///< by its index in the settings
    /// Moves a whole actor rigidly and stops it; joint positions stay.
    virtual void moveActor(ActorHandle actor, const Pose& motion) = 0;

    /// Adds kg m^2 about a joint's axis to its child, before the first step: a geared rotor that turns with it. Not for sliders.
    [[nodiscard]] virtual Status addAxialInertia(JointHandle joint, double inertia) = 0;

    /// Finds the contacts of everything as it is, without a step: contactCount() and contact() then give them, with no forces.
    virtual void findContacts() = 0;

    /// The whole tick: writes, pairs, contacts, dynamics, publication.
    [[nodiscard]] virtual std::optional<EngineFault> step(double h) = 0;

    // Reads, of the last step.
    [[nodiscard]] virtual const BodyState& state(BodyHandle body) const = 0;
    [[nodiscard]] virtual double jointPosition(JointHandle joint) const = 0; ///< unwrapped
    [[nodiscard]] virtual double jointRate(JointHandle joint) const = 0;
    [[nodiscard]] virtual double jointMotorEffort(JointHandle joint) const = 0;
    [[nodiscard]] virtual std::size_t contactCount() const = 0;
    [[nodiscard]] virtual EngineContact contact(std::size_t index) const = 0;
    /// Indices of the contacts of one geom, ascending. Good until the next step.
    [[nodiscard]] virtual std::span<const std::uint32_t> contactsOf(GeomHandle geom) const = 0;
    /// Nearest hit along a unit direction; geoms of `without` are left out.
    [[nodiscard]] virtual std::optional<RayHit> ray(const Vec3& origin, const Vec3& direction, double range,
                                                    ActorHandle without) const = 0;

    /// Steps that the quick solver took, asked or not.
    [[nodiscard]] virtual std::uint64_t quickTicks() const = 0;
    /// Steps that the exact solver could not take at the first attempt, however they ended.
    [[nodiscard]] virtual std::uint64_t rescuedTicks() const = 0;
    /// Contacts in the largest cluster that the exact solver took on so far because Solver = exact says so; counted only above
    /// kExactClusterMax.
    [[nodiscard]] virtual std::size_t largestExactCluster() const = 0;
    /// Complaints of the solver about singular systems: a health counter, 0 in a sound world.
    [[nodiscard]] virtual std::uint64_t complaints() const = 0;
};

/// The rigid-body engine (ODE).
[[nodiscard]] Result<std::unique_ptr<Engine>> makeOdeEngine(const EngineSettings& settings);

} // namespace trundle
