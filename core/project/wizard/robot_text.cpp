#include "project/wizard/robot_text.h"

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <numbers>

namespace trundle {
namespace {

constexpr double kDegrees = std::numbers::pi / 180;
constexpr double kWheelShare = 0.04, kSmallShare = 0.01; // of the mass: a wheel; a slider or what carries a steered wheel

__attribute__((format(printf, 1, 2))) std::string line(const char* format, ...) {
    char text[500];
    va_list values;
    va_start(values, format);
    std::vsnprintf(text, sizeof text, format, values);
    va_end(values);
    return text;
}

/// As a person writes it.
double rounded(double value, int digits) {
    const double unit = std::pow(10, digits - 1 - std::floor(std::log10(value)));
    return std::round(value * unit) / unit;
}
double wheelMass(const RobotDesign& d) { return rounded(kWheelShare * d.mass, 2); }
double smallMass(const RobotDesign& d) { return rounded(kSmallShare * d.mass, 2); }

double hullMass(const RobotDesign& d) {
    const int wheels = d.base == BaseShape::Ackermann ? 4 : drivenWheels(d.base);
    const int small = d.base == BaseShape::Differential ? 1 : d.base == BaseShape::Ackermann ? 2 : 0;
    return d.mass - wheels * wheelMass(d) - small * smallMass(d);
}

const char* describedAs(BaseShape base) {
    switch (base) {
    case BaseShape::Differential: return "two driven wheels and a slider behind them";
    case BaseShape::SkidSteer: return "four driven wheels that do not steer: in a turn they skid";
    case BaseShape::Omni: return "three omni wheels, moves in any direction";
    case BaseShape::Mecanum: return "four mecanum wheels, moves in any direction";
    case BaseShape::Ackermann: break;
    }
    return "driven at the back and steered in front, as a car";
}

/// The geometry of the wheel, its axle and its motor. Torque and speed constants of a motor without losses are equal; what the
/// stall torque lacks is the gear's.
std::string drivenWheel(const RobotDesign& d, const GearMotor& m, const char* hpr, const char* axis, const char* surface,
                        const char* place = "") {
    const double constant = m.voltage / (m.noLoadSpeed * m.gearRatio);
    const double efficiency = m.stallTorque * m.noLoadSpeed / (m.voltage * m.stallCurrent);
    return line("  Param radius = %.6g   // the Part gives its own\n", d.wheelRadius) +
           line("  Body wheel        { %sCylinder tyre { Radius=$radius Length=%.4g HPR=%s Mass=%.4g Material=black Surface=%s } "
                "}\n",
                place, wheelWidth(d), hpr, wheelMass(d), surface) +
           line("  Hinge axle        { Parent=$carrier Child=wheel  Axis=%s }\n", axis) +
           line("  RotaryMotor motor {\n    Joint=axle  TorqueConstant=%.3g BackEmfConstant=%.3g Resistance=%.3g\n    "
                "GearRatio=%.4g "
                "Efficiency=%.2g MaxVoltage=%g }\n",
                constant, constant, m.voltage / m.stallCurrent, m.gearRatio, efficiency, m.voltage);
}

std::string drivenWheelConfig(const RobotDesign& d, const GearMotor& motor) {
    const std::string head = "PartConfig " + d.name + "Wheel {\n";
    switch (d.base) {
    case BaseShape::Omni:
        return "Surface omniRollers { Friction=0.8 Friction2=0 }   // roll freely along the axle\n\n// Ahead of the middle; the "
               "Part turns it "
               "into its place.\n" +
               head + line("  Param distance = %.6g\n", d.wheelSeparation / 2) +
               drivenWheel(d, motor, "90,0,90", "-1,0,0", "omniRollers", "Pos=$distance,0,$radius  ") + "}\n\n";
    case BaseShape::Mecanum:
        return "Surface mecanumRollers { Friction=0.8 Friction2=0 FrictionHeading=-45 }   // front left; mirrored on the other "
               "diagonal\n\n" +
               head + drivenWheel(d, motor, "0,0,90", "0,1,0", "mecanumRollers") + "}\n\n";
    default: return head + drivenWheel(d, motor, "0,0,90", "0,1,0", "rubber") + "}\n\n";
    }
}

std::string steeredWheelConfig(const RobotDesign& d) {
    const double torque = std::max(0.5, rounded(0.3 * d.mass * 9.81 * d.wheelRadius, 2)), block = rounded(d.wheelRadius * 0.6, 2);
    return "PartConfig " + d.name + "SteeredWheel {\n" +
           line("  Param radius = %.6g   // the Part gives its own\n", d.wheelRadius) +
           line("  Body knuckle   { Box block { Size=%.4g,%.4g,%.4g Mass=%.4g Collide=false Material=steel Surface=plastic } }\n",
                block, wheelWidth(d), block, smallMass(d)) +
           "  Hinge pivot    { Parent=$carrier Child=knuckle  Axis=0,0,1 }\n" +
           line("  Servo steering { Joint=pivot MaxTorque=%.4g MaxSpeed=6 }\n", torque) +
           line("  Body wheel     { Cylinder tyre { Radius=$radius Length=%.4g HPR=0,0,90 Mass=%.4g Material=black "
                "Surface=rubber } }\n",
                wheelWidth(d), wheelMass(d)) +
           "  Hinge axle     { Parent=knuckle Child=wheel  Axis=0,1,0 }\n}\n\n";
}

std::string params(const RobotDesign& d) {
    const bool isOmni = d.base == BaseShape::Omni;
    std::string text = line("  Param wheelRadius     = %.6g\n", d.wheelRadius);
    text += isOmni ? line("  Param wheelDistance   = %.6g   // from the middle\n", d.wheelSeparation / 2)
                   : line("  Param wheelSeparation = %.6g\n", d.wheelSeparation);
    if (hasWheelBase(d.base)) text += line("  Param wheelBase       = %.6g\n", d.wheelBase);
    return text + "\n";
}

/// The hull, and a white stripe that shows where its front is.
std::string chassis(const RobotDesign& d) {
    const double z = groundClearance(d) + d.height / 2, stripe = std::max(0.004, rounded(d.length * 0.05, 1));
    const double x = d.base == BaseShape::Differential ? -0.2 * d.length : d.base == BaseShape::Ackermann ? d.wheelBase / 2 : 0;
    std::string text = "  Body chassis {\n";
    if (d.base == BaseShape::Omni)
        text += line("    Cylinder hull { Radius=%.6g Length=%.6g Pos=0,0,%.6g Mass=%.4g Material=orange Surface=plastic }\n",
                     d.width / 2, d.height, z, hullMass(d));
    else
        text += line("    Box hull      { Size=%.6g,%.6g,%.6g Pos=%.6g,0,%.6g Mass=%.4g Material=orange Surface=plastic }\n",
                     d.length, d.width, d.height, x, z, hullMass(d));
    const double front = d.base == BaseShape::Omni ? 0.35 * d.width : x + d.length / 2 - 1.5 * stripe;
    text += line("    Box front     { Size=%.4g,%.4g,0.002 Pos=%.4g,0,%.6g Collide=false Material=white Surface=plastic }\n",
                 stripe, rounded(0.5 * d.width, 2), front, groundClearance(d) + d.height + 0.001);
    if (d.base == BaseShape::Differential)
        text += line("    Sphere slider { Radius=%.4g Pos=%.4g,0,%.4g Mass=%.4g Material=darkgrey Surface=slick }\n",
                     groundClearance(d) / 2, -0.6 * d.length, groundClearance(d) / 2, smallMass(d));
    return text + "  }\n";
}

std::string part(const RobotDesign& d, const std::string& name, const char* kind, const char* x, bool isLeft, bool isMirrored) {
    return "  Part " + name + " { Config=" + d.name + kind + " Pos=" + x +
           (isLeft ? ",$(wheelSeparation/2)" : ",$(-wheelSeparation/2)") + ",$wheelRadius" + (isMirrored ? " Mirror=y" : "") +
           "  carrier=chassis radius=$wheelRadius }\n";
}

std::string twoWheels(const RobotDesign& d) {
    return part(d, "left ", "Wheel", "0", true, false) + part(d, "right", "Wheel", "0", false, false);
}

/// Mirrored on one diagonal where its wheels have a side.
std::string fourWheels(const RobotDesign& d) {
    const bool mirrors = d.base == BaseShape::Mecanum;
    return part(d, "frontLeft ", "Wheel", "$(wheelBase/2)", true, false) +
           part(d, "frontRight", "Wheel", "$(wheelBase/2)", false, mirrors) +
           part(d, "backLeft  ", "Wheel", "$(-wheelBase/2)", true, mirrors) +
           part(d, "backRight ", "Wheel", "$(-wheelBase/2)", false, false);
}

std::string threeWheels(const RobotDesign& d) {
    std::string text;
    for (const auto& [name, heading] : {std::pair{"left ", 60}, {"back ", 180}, {"right", 300}})
        text += line("  Part %s { Config=%sWheel HPR=%d,0,0", name, d.name.c_str(), heading) +
                "  carrier=chassis radius=$wheelRadius distance=$wheelDistance }\n";
    return text;
}

std::string skidDrive(const RobotDesign& d) {
    return "  SkidDrive base {\n    LeftMotors=frontLeft.motor,backLeft.motor  RightMotors=frontRight.motor,backRight.motor\n    "
           "WheelRadius=$wheelRadius WheelSeparation=$wheelSeparation " +
           line("SkidFactor=%.4g }\n", skidFactor(d));
}

std::string wheelsAndDrive(const RobotDesign& d) {
    switch (d.base) {
    case BaseShape::Differential:
        return twoWheels(d) + "\n  DifferentialDrive base { LeftMotor=left.motor RightMotor=right.motor WheelRadius=$wheelRadius "
                              "WheelSeparation=$wheelSeparation }\n";
    case BaseShape::SkidSteer: return fourWheels(d) + "\n" + skidDrive(d);
    case BaseShape::Omni:
        return threeWheels(d) + "\n  OmniDrive base { Motors=left.motor,back.motor,right.motor WheelRadius=$wheelRadius "
                                "WheelDistance=$wheelDistance }\n";
    case BaseShape::Mecanum:
        return fourWheels(d) +
               "\n  MecanumDrive base {\n    FrontLeftMotor=frontLeft.motor FrontRightMotor=frontRight.motor\n    "
               "BackLeftMotor=backLeft.motor BackRightMotor=backRight.motor\n    WheelRadius=$wheelRadius "
               "WheelBase=$wheelBase WheelSeparation=$wheelSeparation }\n";
    case BaseShape::Ackermann: break;
    }
    return twoWheels(d) + part(d, "frontLeft ", "SteeredWheel", "$wheelBase", true, false) +
           part(d, "frontRight", "SteeredWheel", "$wheelBase", false, false) +
           "\n  AckermannDrive base {\n    LeftMotor=left.motor RightMotor=right.motor\n    LeftSteering=frontLeft.steering "
           "RightSteering=frontRight.steering\n    WheelRadius=$wheelRadius WheelSeparation=$wheelSeparation "
           "WheelBase=$wheelBase }\n";
}

} // namespace

std::string robotText(const RobotDesign& d, const MotorChoice& choice) {
    std::string text = "// " + d.name + ": " + describedAs(d.base) + ".\n// Motors: " + std::string(choice.motor.name);
    text += line(", for %.2g m/s with a reserve of 20 %% and slopes of up to %.0f degrees.\n", choice.topSpeed,
                 std::floor(choice.slope / kDegrees));
    text += "#import common/materials.sim\n#import common/surfaces.sim\n\n" + drivenWheelConfig(d, choice.motor);
    if (d.base == BaseShape::Ackermann) text += steeredWheelConfig(d);
    std::string wheels = wheelsAndDrive(d);
    return text + "RobotConfig " + d.name + " {\n" + params(d) + chassis(d) + wheels + "}\n";
}

} // namespace trundle
