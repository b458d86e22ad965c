#pragma once
// The motors and wheels of drives, for the checks.

#include <optional>
#include <string>
#include <vector>

#include "model/experiment_spec.h"

namespace trundle {

/// A motor as a drive names it.
struct DriveMotor {
    const char* key; ///< "LeftMotors"
    std::string name;
    const ResolvedValue* value;
    bool isRight = false, isBack = false;
    std::size_t index = 0; ///< in the value

    [[nodiscard]] const SourceRange& place() const { return value->rangeOf(index); } ///< of its name
};

/// The motors of a drive's wheels; empty for other devices.
[[nodiscard]] std::vector<DriveMotor> motorsOf(const ComponentSpec& device);

/// A wheel, from its geom and joint. Vectors in the config's frame.
struct DriveWheel {
    const GeomSpec* geom = nullptr;
    const ComponentSpec* motor = nullptr; ///< nullptr: a free wheel
    std::size_t body = 0;
    Vec3 centre = Vec3::Zero(), axis = Vec3::UnitY();

    [[nodiscard]] double stallTorque() const; ///< N m, at the wheel
    [[nodiscard]] double topRate() const;     ///< rad/s, without load
};

/// Whether a Gear couples the joint to another one.
[[nodiscard]] bool isGeared(const RobotConfigSpec& config, const JointSpec& joint);
/// The largest round geom of the motor's body that rotates about its axle; nothing where a Gear leads on from there.
[[nodiscard]] std::optional<DriveWheel> wheelOf(const RobotConfigSpec& config, const std::string& motor);
/// Of all drives of a config; those that are found.
[[nodiscard]] std::vector<DriveWheel> drivenWheelsOf(const RobotConfigSpec& config);
/// What turns about a joint and may roll on the floor, geared or not, with a motor or without; nothing for other joints.
[[nodiscard]] std::optional<DriveWheel> wheelOn(const RobotConfigSpec& config, const JointSpec& joint);
/// The body with the sphere on which a wheel of its robot rolls, as that of a robot that balances on a ball; nothing for others.
[[nodiscard]] std::optional<std::size_t> ballUnder(const RobotConfigSpec& config, const DriveWheel& wheel);
/// Wheels that no drive turns: cylinders about the level axles of joints without a motor or Gear.
[[nodiscard]] std::vector<DriveWheel> freeWheelsOf(const RobotConfigSpec& config);

} // namespace trundle
