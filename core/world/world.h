#pragma once
// The world of one run: engine, devices and signals built from an experiment, and ticked in the fixed order act, collide, step,
// sense, publish. Controllers (think) are called before tick() by core/run.

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <trundle/abi.h>
#include <trundle/geometry.h>

#include "base/call_monitor.h"
#include "base/diagnostic.h"
#include "base/result.h"
#include "model/experiment_spec.h"
#include "signals/block.h"
#include "signals/layout.h"
#include "world/engine_solves.h"

namespace trundle {

class JoinedRobots;
class Medium;

/// The code of a device kind.
struct DeviceKind {
    const TrundleKind* table = nullptr; ///< its functions; null: the kind is unknown
    std::function<void*()> create = {}; ///< makes an instance where the table alone cannot

    DeviceKind(const TrundleKind* functions) : table(functions) {} // NOLINT(google-explicit-constructor): most are a table
    DeviceKind(const TrundleKind* functions, std::function<void*()> maker) : table(functions), create(std::move(maker)) {}
};
/// Returns the code of a device kind, built-in or from a module.
using DeviceCode = std::function<DeviceKind(const std::string& kind)>;
/// Receives texts printed by devices: device path, severity (TRUNDLE_INFO ...), text.
using DeviceText = std::function<void(const std::string&, int, const std::string&)>;

/// One contact of the last tick. Sorted by (actor, partner, geom), and so identical in every run.
struct WorldContact {
    std::string_view first, second; ///< geom paths "robot0/chassis/bumper", "arena/north"
    Vec3 position = Vec3::Zero();
    Vec3 normal = Vec3::UnitZ();  ///< towards `first`
    double depth = 0;             ///< m
    double force = 0;             ///< N along the normal
    Vec3 friction = Vec3::Zero(); ///< N across the normal, in the world, on `first`; the opposite acts on `second`
};

/// Kinetic and potential energy of one robot, J.
struct RobotEnergy {
    double kinetic = 0, potential = 0;
};

/// Why and where a world stopped permanently.
struct Fault {
    std::string body; ///< path; empty if the whole world is affected
    double time = 0;
    std::string reason;
    SourceRange range; ///< the name of the body or device in the text
};

/// A robot or object that ended by a fault of its own: it stays where it was, touches nothing, and its controller and devices are
/// not called any more. All others continue.
struct RobotEnd {
    std::size_t robot = 0;
    Fault fault;
};

/// Faults of single robots, while the run continues.
struct RobotFaultReport {
    std::vector<RobotEnd> ends;      ///< in the order in which they ended
    std::vector<Fault> closedJoints; ///< that a tick tore open and that were closed again: the first of each robot, at most 20
};

/// Bodies that move farther in a tick than they are thick.
struct SweepReport {
    std::uint64_t bodies = 0;                                ///< times ticks, whose paths were searched for scenery
    std::vector<std::pair<std::string, std::string>> passed; ///< geoms that passed through each other; once for two robots
};

class WorkTeam;

class World {
public:
    /// Builds everything at its start pose; tick 0 is the initial state with valid signals. Everything that cannot be built is
    /// reported as a diagnostic at its source range, and the result is null. `calls` is updated during the lifetime of the world.
    [[nodiscard]] static std::unique_ptr<World> build(std::shared_ptr<const ExperimentSpec> experiment, const DeviceCode& devices,
                                                      Diagnostics& diagnostics, std::shared_ptr<CallMonitor> calls = nullptr);
    virtual ~World() = default;

    /// With the engine that it has in the settings, where those say Auto.
    [[nodiscard]] virtual const ExperimentSpec& experiment() const = 0;
    [[nodiscard]] virtual const SignalLayout& layout() const = 0;
    [[nodiscard]] virtual SignalBlock& block() = 0;
    [[nodiscard]] virtual const SignalBlock& block() const = 0;

    /// Runs act, collide, step, sense, publish. After a fault() the world cannot be stepped again: E501 names body and time.
    [[nodiscard]] virtual Status tick() = 0;
    /// The threads of the ticks, for controllers between them; nullptr: one.
    [[nodiscard]] virtual WorkTeam* threads() { return nullptr; }
    [[nodiscard]] virtual const Fault* fault() const = 0;

    /// A world in which no robot is left has a fault() too.
    [[nodiscard]] virtual const RobotFaultReport& robotFaults() const;

    [[nodiscard]] virtual std::uint64_t ticks() const = 0;
    [[nodiscard]] double time() const { return static_cast<double>(ticks()) * experiment().settings.tick; }
    [[nodiscard]] virtual EngineSolves solves() const { return {}; } ///< of the whole run
    [[nodiscard]] virtual SweepReport sweeps() const { return {}; } ///< of the whole run

    /// FNV-1a 64 over position, quaternion (w x y z), linear and angular velocity as little-endian doubles, bodies in path order.
    [[nodiscard]] virtual std::uint64_t stateHash() const = 0;
    /// Pose in the world of a robot's config frame, which is attached to its first body.
    [[nodiscard]] virtual Pose robotPose(std::size_t robot) const = 0;
    /// Pose in the world that the signal `pose` and logs report: that of the config frame. For a passive object (isPassive) its
    /// position is that of the centre of mass of its first body, as the config frame of a ball that rolls circles around it.
    [[nodiscard]] virtual Pose reportedPose(std::size_t robot) const { return robotPose(robot); }
    [[nodiscard]] virtual RobotEnergy robotEnergy(std::size_t robot) const = 0;
    [[nodiscard]] virtual const std::vector<WorldContact>& contacts() const = 0;

    /// The radio medium between the robots at their current poses; nullptr in a world without radio.
    [[nodiscard]] virtual Medium* medium() const { return nullptr; }

    // External commands, applied at the start of the next tick (core/run stamps them with their tick).
    /// Applies a force (N, world) at a point (m, world) to the body "robot0/chassis" for one tick.
    [[nodiscard]] virtual Status push(const std::string& body, const Vec3& force, const Vec3& point) = 0;
    /// Moves a robot to a pose, and what joints at the top level join to it along, with zero velocity; refused where one of these joints
    /// holds them to the world. Of several in a tick the last one counts.
    [[nodiscard]] virtual Status place(const std::string& robot, const Pose& pose) = 0;
    /// Replaces the values of the surface with that name.
    [[nodiscard]] virtual Status setSurface(const SurfaceSpec& surface) = 0;
    /// Sets a property of a device "robot0/leftMotor" that its kind declares as live, in SI units.
    [[nodiscard]] virtual Status setProperty(const std::string& device, const std::string& property,
                                             const PropertyValue& value) = 0;

    /// Sets the listener; texts printed while the world was built are passed to it at once.
    virtual void setDeviceText(DeviceText text) = 0;
};

[[nodiscard]] bool hasEnded(const World& world, std::size_t robot);

// Why a world refuses a command to a robot, or that it does not; also before the tick for which the command is meant.
[[nodiscard]] Status checkPush(const World& world, std::size_t robot, const Vec3& force, const Vec3& point);
[[nodiscard]] Status checkPlace(const World& world, const JoinedRobots& joined, std::size_t robot, const Pose& pose);

/// How many threads compute the motion in a world of this experiment, with the one that calls tick(). No result depends on it.
[[nodiscard]] unsigned threadsFor(const ExperimentSpec& experiment);

} // namespace trundle
