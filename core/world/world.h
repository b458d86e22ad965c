#pragma once
// The world of one run: engine, devices and signals built from an experiment, ticked in the fixed order
// act, collide, step, sense, publish (think, the controllers' turn, comes before tick() and belongs to run).

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <trundle/abi.h>
#include <trundle/geometry.h>

#include "base/call_monitor.h"
#include "base/diagnostic.h"
#include "base/result.h"
#include "model/experiment_spec.h"
#include "signals/block.h"
#include "signals/layout.h"

namespace trundle {

class Medium;

/// The code of a device kind, built in or from a module; nullptr where none is known.
using DeviceCode = std::function<const TrundleKind*(const std::string& kind)>;
/// Where a device's text goes: device path, severity (TRUNDLE_INFO ...), text.
using DeviceText = std::function<void(const std::string&, int, const std::string&)>;

/// One contact of the last tick. Sorted by (actor, partner, geom): the same in every run.
struct WorldContact {
    std::string_view first, second; ///< geom paths "robot0/chassis/bumper", "arena/north"
    Vec3 position = Vec3::Zero();
    Vec3 normal = Vec3::UnitZ(); ///< towards `first`
    double depth = 0;            ///< m
    double force = 0;            ///< N along the normal
};

/// Kinetic and potential energy of one robot, J.
struct RobotEnergy {
    double kinetic = 0, potential = 0;
};

/// Why and where a world stopped for good.
struct Fault {
    std::string body; ///< path, empty where it is the whole world
    double time = 0;
    std::string reason;
    SourceRange range; ///< the name of the body (of the device) in the text
};

class World {
public:
    /// Builds everything at its start pose; tick 0 is the initial state and its signals are valid.
    /// What cannot be built is a diagnostic at its place; then there is no world. `calls` is kept up to date for as long as the world is
    /// there.
    [[nodiscard]] static std::unique_ptr<World> build(std::shared_ptr<const ExperimentSpec> experiment, const DeviceCode& devices,
                                                      Diagnostics& diagnostics, std::shared_ptr<CallMonitor> calls = nullptr);
    virtual ~World() = default;

    [[nodiscard]] virtual const ExperimentSpec& experiment() const = 0;
    [[nodiscard]] virtual const SignalLayout& layout() const = 0;
    [[nodiscard]] virtual SignalBlock& block() = 0;
    [[nodiscard]] virtual const SignalBlock& block() const = 0;

    /// act, collide, step, sense, publish. After a fault the world is never stepped again: E501 names body and time.
    [[nodiscard]] virtual Status tick() = 0;
    [[nodiscard]] virtual const Fault* fault() const = 0;

    [[nodiscard]] virtual std::uint64_t ticks() const = 0;
    [[nodiscard]] double time() const { return static_cast<double>(ticks()) * experiment().settings.tick; }
    /// Ticks the quick solver took: all under Solver = quick, large clusters under auto, and what the exact one could not solve at all.
    [[nodiscard]] virtual std::uint64_t quickTicks() const = 0;
    /// Ticks that the exact solver could not take at the first attempt: taken again with more give, at last by the quick one.
    [[nodiscard]] virtual std::uint64_t rescuedTicks() const = 0;
    /// Contacts in the largest cluster that Solver = exact had to take on, where that was more than is sane; else 0.
    [[nodiscard]] virtual std::size_t largestExactCluster() const = 0;

    /// FNV-1a 64 over position, quaternion (w x y z), linear and angular velocity as little-endian doubles, bodies in path order.
    [[nodiscard]] virtual std::uint64_t stateHash() const = 0;
    /// Pose of a robot's config frame, carried by its first body.
    [[nodiscard]] virtual Pose robotPose(std::size_t robot) const = 0;
    [[nodiscard]] virtual RobotEnergy robotEnergy(std::size_t robot) const = 0;
    [[nodiscard]] virtual const std::vector<WorldContact>& contacts() const = 0;

    /// The air between the robots' radios as they stand now; nullptr in a world without.
    [[nodiscard]] virtual Medium* medium() const { return nullptr; }

    // Commands from outside, applied at the start of the next tick (they enter stamped, through run).
    /// Force (N, world) at a point (m, world) on a body "robot0/chassis" for one tick.
    [[nodiscard]] virtual Status push(const std::string& body, const Vec3& force, const Vec3& point) = 0;
    /// Puts a robot at a pose, at rest.
    [[nodiscard]] virtual Status place(const std::string& robot, const Pose& pose) = 0;
    /// Gives the surface of that name other values.
    [[nodiscard]] virtual Status setSurface(const SurfaceSpec& surface) = 0;
    /// Sets a field of a device "robot0/leftMotor" that its kind describes as live, SI units.
    [[nodiscard]] virtual Status setProperty(const std::string& device, const std::string& property,
                                             const PropertyValue& value) = 0;

    /// What devices said while the world was built is given at once.
    virtual void setDeviceText(DeviceText text) = 0;
};

} // namespace trundle
