#pragma once
// What a person says of a new robot, and the motor that this needs.

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace trundle {

enum class BaseShape { Differential, SkidSteer, Omni, Mecanum, Ackermann };
constexpr BaseShape kBaseShapes[] = {BaseShape::Differential, BaseShape::SkidSteer, BaseShape::Omni, BaseShape::Mecanum,
                                     BaseShape::Ackermann};

/// m, kg, m/s. The hull is a box; of an omni base, a cylinder as wide as `width`, whose wheels are on a circle as wide as
/// `wheelSeparation`. `wheelBase` counts only where `hasWheelBase`.
struct RobotDesign {
    std::string name = "Rover"; ///< of its RobotConfig: a capital letter, then letters, digits and _
    BaseShape base = BaseShape::Differential;
    double length = 0.3, width = 0.2, height = 0.1;
    double wheelRadius = 0.05, wheelSeparation = 0.25, wheelBase = 0.2;
    double mass = 3; ///< of the whole robot
    double topSpeed = 0.5;
};

/// A number of a design and its limits.
struct DesignNumber {
    const char* name; ///< as a sentence begins: "The wheel radius"
    double RobotDesign::*value;
    double least, most;
    const char* unit;
};
[[nodiscard]] const std::array<DesignNumber, 8>& designNumbers();

/// Dimensions to start from.
[[nodiscard]] RobotDesign usualDesign(BaseShape base);
/// Gives the wheels the places that go with the hull, where these were not chosen: a wheelbase in proportion to the length, a wheel
/// separation as usual, or as large as hull and wheels need.
void placeWheels(RobotDesign& design, bool choosesSeparation, bool choosesWheelBase);
[[nodiscard]] bool hasWheelBase(BaseShape base);
[[nodiscard]] int drivenWheels(BaseShape base);
/// m: half of the radius, to the millimetre.
[[nodiscard]] double wheelWidth(const RobotDesign& design);
/// m from the floor to the hull.
[[nodiscard]] double groundClearance(const RobotDesign& design);

/// SkidFactor of a skid-steered base; 1 of others. Point contacts that slip by Coulomb's law without a force along: the sides run
/// 1 + (wheelbase / separation)^2 times as fast as without skidding.
[[nodiscard]] double skidFactor(const RobotDesign& design);

/// A DC motor with a gear; all values at its output shaft.
struct GearMotor {
    std::string_view name;
    double voltage;      ///< V
    double noLoadSpeed;  ///< rad/s
    double stallTorque;  ///< N m
    double stallCurrent; ///< A
    double gearRatio;
    double gearTorque; ///< N m, the most that its gear takes for a short time

    [[nodiscard]] double usableTorque() const; ///< N m: half of the stall torque, where a motor is strongest, or that of its gear
};
/// From the weakest to the strongest; motors of the same strength from the slowest to the fastest.
[[nodiscard]] const std::vector<GearMotor>& gearMotors();

/// What a robot reaches with a motor.
struct MotorChoice {
    GearMotor motor;
    double topSpeed = 0; ///< m/s, with the reserve
    double slope = 0;    ///< rad, the steepest that it climbs
};

constexpr double kSpeedReserve = 0.2;
constexpr double kLeastSlopeDeg = 10;

[[nodiscard]] MotorChoice reachedWith(const GearMotor& motor, const RobotDesign& design);
/// The first motor of the table that turns the wheels at the top speed, with a reserve of 20 %, and climbs 10 degrees, and turns a
/// skid-steered base on the spot. Fails with the limit: of the dimensions, of the speed, or of the torque.
[[nodiscard]] Result<MotorChoice> chooseMotor(const RobotDesign& design);

} // namespace trundle
