#include "project/wizard/robot_design.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <optional>

namespace trundle {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kGravity = 9.81;
constexpr double kTyreFriction = 1; // of the surface rubber on the surface ground
constexpr double kBraking = 1;      // m/s^2, MaxAcceleration of a base
constexpr double kRocking = 1.4;    // see rockingFault()
constexpr double kGap = 0.002;      // m between hull and wheel

template <class... T> std::string say(const char* format, T... values) {
    char text[300];
    std::snprintf(text, sizeof text, format, values...);
    return text;
}

std::optional<std::string> rangeFault(const RobotDesign& d) {
    for (const DesignNumber& n : designNumbers()) {
        const double value = d.*n.value;
        if (n.value == &RobotDesign::wheelBase && !hasWheelBase(d.base)) continue;
        if (!(value >= n.least && value <= n.most)) // not a number fails too
            return say("%s must be from %g to %g %s, not %g.", n.name, n.least, n.most, n.unit, value);
    }
    return std::nullopt;
}

/// m: a wheel that is steered by 35 degrees needs this beside the hull.
double besideHull(const RobotDesign& d) {
    return kGap + (d.base == BaseShape::Ackermann ? std::sin(35 * kDegree) * d.wheelRadius : 0);
}

double leastSeparation(const RobotDesign& d) { return d.width + wheelWidth(d) + 2 * besideHull(d); }
double leastWheelBase(const RobotDesign& d) {
    return std::max(2 * d.wheelRadius + kGap, d.base == BaseShape::Ackermann ? 0.6 * d.wheelSeparation : 0);
}

std::optional<std::string> fitFault(const RobotDesign& d) {
    const double separation = leastSeparation(d);
    if (d.wheelSeparation < separation)
        return say("The wheels touch the hull: the wheel separation must be at least %.3g m with this hull and these wheels.",
                   std::ceil(separation * 1e3) / 1e3);
    const double wheelBase = leastWheelBase(d);
    if (hasWheelBase(d.base) && d.wheelBase < wheelBase)
        return say("The wheelbase must be at least %.3g m with these wheels.", std::ceil(wheelBase * 1e3) / 1e3);
    return std::nullopt;
}

/// From the middle of mass to the nearest edge on which it could tip over, m.
double footing(const RobotDesign& d) {
    switch (d.base) {
    case BaseShape::Differential: return std::min(0.18 * d.length, d.wheelSeparation / 2);
    case BaseShape::Omni: return d.wheelSeparation / 4; // of the circle that fits in the triangle of the wheels
    default: return std::min(d.wheelBase, d.wheelSeparation) / 2;
    }
}

/// m above the floor.
double middleOfMass(const RobotDesign& d) { return groundClearance(d) + d.height / 2; }

std::optional<std::string> tippingFault(const RobotDesign& d) {
    const double middle = groundClearance(d) + d.height / 2,
                 needed = middle * (std::tan(kLeastSlopeDeg * kDegree) + kBraking / kGravity);
    if (footing(d) >= needed) return std::nullopt;
    return say("It would tip over when it brakes on a slope of %g degrees: make the hull lower, or longer and wider.",
               kLeastSlopeDeg);
}

/// Wheels that skid in a turn carry more where the base leans to, and push it farther there: across by the share of their slip across,
/// ahead by that along. Measured: from a product of 1.5 on it rocks from wheel to wheel and turns by another angle.
std::optional<std::string> rockingFault(const RobotDesign& d) {
    if (d.base != BaseShape::SkidSteer) return std::nullopt;
    const double ratio = d.wheelBase / d.wheelSeparation, shares = ratio / (1 + ratio * ratio);
    const double highest = std::sqrt(kRocking * d.wheelBase * d.wheelSeparation / 4 / shares) / kTyreFriction;
    if (middleOfMass(d) <= highest) return std::nullopt;
    return say(
        "It would rock from wheel to wheel when it skids in a turn: make the hull at most %.2g m high, or wheelbase and wheel "
        "separation larger.",
        std::floor(200 * (highest - groundClearance(d))) / 100);
}

/// How many times the force of one wheel moves the base, in its weakest direction; of mecanum wheels, ahead. Three omni wheels
/// across a line between two of them: 1, and twice 1/2 of wheels that roll at half of the rate.
double wheelsPushing(BaseShape base) { return base == BaseShape::Omni ? 1.5 : drivenWheels(base); }

/// Of the weight, in its weakest direction: the share of the driven wheels times their friction. Rollers grip with 0.8 along one line.
double grip(BaseShape base) {
    switch (base) {
    case BaseShape::Differential: return 0.7 * kTyreFriction;
    case BaseShape::Ackermann: return 0.5 * kTyreFriction;
    case BaseShape::Omni: return 0.8 * 1.5 / 3;
    case BaseShape::Mecanum: return 0.8 * std::numbers::sqrt2 / 2;
    case BaseShape::SkidSteer: break;
    }
    return kTyreFriction;
}

/// N m. Wheels of a skid-steered base slip along and across as a^2/b and a, with half of the wheelbase a and of the separation b.
double turningTorque(const RobotDesign& d) {
    if (d.base != BaseShape::SkidSteer) return 0;
    const double ratio = d.wheelBase / d.wheelSeparation;
    return kTyreFriction * d.mass * kGravity / 4 * d.wheelRadius * ratio / std::hypot(1, ratio);
}

bool climbs(const MotorChoice& reached) { return reached.slope >= kLeastSlopeDeg * kDegree; }
bool turns(const GearMotor& motor, const RobotDesign& d) { return motor.usableTorque() >= turningTorque(d); }

Error failure(std::string text) { return Error{Code::OutOfRange, std::move(text)}; }

} // namespace

const std::array<DesignNumber, 8>& designNumbers() {
    static constexpr std::array<DesignNumber, 8> numbers{{
        {"The length of the hull", &RobotDesign::length, 0.05, 5, "m"},
        {"The width of the hull", &RobotDesign::width, 0.03, 5, "m"},
        {"The height of the hull", &RobotDesign::height, 0.01, 3, "m"},
        {"The wheel radius", &RobotDesign::wheelRadius, 0.01, 1, "m"},
        {"The wheel separation", &RobotDesign::wheelSeparation, 0.03, 10, "m"},
        {"The wheelbase", &RobotDesign::wheelBase, 0.03, 10, "m"},
        {"The mass", &RobotDesign::mass, 0.1, 1000, "kg"},
        {"The top speed", &RobotDesign::topSpeed, 0.01, 20, "m/s"},
    }};
    return numbers;
}

RobotDesign usualDesign(BaseShape base) {
    RobotDesign d;
    d.base = base;
    if (base == BaseShape::SkidSteer || base == BaseShape::Mecanum) d.wheelSeparation = 0.26;
    if (base == BaseShape::Omni) d.wheelSeparation = 0.25;
    if (base == BaseShape::Ackermann) d.length = 0.4, d.width = 0.14, d.wheelSeparation = 0.24, d.wheelBase = 0.28;
    return d;
}

void placeWheels(RobotDesign& d, bool choosesSeparation, bool choosesWheelBase) {
    const RobotDesign usual = usualDesign(d.base);
    const auto atLeast = [](double usually, double least) {
        return std::max(usually, std::ceil(least * 100 - 1e-6) / 100);
    }; // to the cm
    if (choosesSeparation) d.wheelSeparation = atLeast(usual.wheelSeparation, leastSeparation(d));
    if (choosesWheelBase && hasWheelBase(d.base))
        d.wheelBase = atLeast(std::round(usual.wheelBase / usual.length * d.length * 100) / 100, leastWheelBase(d));
}

bool hasWheelBase(BaseShape base) { return base != BaseShape::Differential && base != BaseShape::Omni; }

int drivenWheels(BaseShape base) {
    switch (base) {
    case BaseShape::SkidSteer:
    case BaseShape::Mecanum: return 4;
    case BaseShape::Omni: return 3;
    default: return 2;
    }
}

double skidFactor(const RobotDesign& d) {
    return d.base == BaseShape::SkidSteer ? 1 + std::pow(d.wheelBase / d.wheelSeparation, 2) : 1;
}

double wheelWidth(const RobotDesign& d) { return std::max(0.004, std::round(d.wheelRadius * 500) / 1000); }
double groundClearance(const RobotDesign& d) { return std::round(d.wheelRadius * 600) / 1000; }

MotorChoice reachedWith(const GearMotor& motor, const RobotDesign& d) {
    const double push = wheelsPushing(d.base) * motor.usableTorque() / d.wheelRadius;
    const double slope = std::asin(std::min(1., push / (d.mass * kGravity)));
    return {motor, motor.noLoadSpeed * d.wheelRadius / (1 + kSpeedReserve),
            std::min({slope, std::atan(grip(d.base)), std::atan(footing(d) / middleOfMass(d))})};
}

Result<MotorChoice> chooseMotor(const RobotDesign& d) {
    for (const auto& fault : {rangeFault(d), fitFault(d), tippingFault(d), rockingFault(d)})
        if (fault) return failure(*fault);
    std::optional<MotorChoice> fastest, strongest; // of all; of those that are fast enough
    for (const GearMotor& motor : gearMotors()) {
        const MotorChoice reached = reachedWith(motor, d);
        if (!fastest || reached.topSpeed > fastest->topSpeed) fastest = reached;
        if (reached.topSpeed < d.topSpeed) continue;
        if (climbs(reached) && turns(motor, d)) return reached;
        if (!strongest || motor.usableTorque() > strongest->motor.usableTorque()) strongest = reached;
    }
    if (!strongest)
        return failure(say(
            "No motor is fast enough: with these wheels %s reaches %.2f m/s with a reserve of 20 %%. Make the wheels larger or "
            "the top speed lower.",
            std::string(fastest->motor.name).c_str(), fastest->topSpeed));
    const std::string name(strongest->motor.name);
    if (!climbs(*strongest))
        return failure(
            say("No motor is strong enough: of those that reach %g m/s, %s climbs a slope of %.1f degrees, and %g are needed. "
                "Make the mass, the wheels or the top speed smaller.",
                d.topSpeed, name.c_str(), strongest->slope / kDegree, kLeastSlopeDeg));
    return failure(say(
        "No motor is strong enough to turn on the spot: each wheel needs %.2f N m against its skidding, and of those that reach "
        "%g m/s, %s has %.2f N m. Make the wheelbase, the mass or the wheels smaller.",
        turningTorque(d), d.topSpeed, name.c_str(), strongest->motor.usableTorque()));
}

} // namespace trundle
