#pragma once
// Kinds of devices, logs and a controller, and a robot made of them: the model has no such kinds of its own.
#include <array>
#include <cassert>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "model/kinds/model_kinds.h"

namespace sample {

using namespace trundle;

struct Motor {
    std::string joint;
    double torqueConstant = 0, resistance = 1, gearRatio = 1;
    std::optional<double> speedConstant, backEmfConstant;
    static void describe(Describe<Motor>& d) {
        d.help("A motor.");
        d.field("Joint", &Motor::joint, reference("Hinge|Slider").required(), "Joint it turns.");
        d.field("TorqueConstant", &Motor::torqueConstant, unitOf("Nm/A").above(0).required(), "Torque per current.");
        d.field("SpeedConstant", &Motor::speedConstant, unitOf("rad/s/V").above(0), "Rate per voltage.");
        d.field("BackEmfConstant", &Motor::backEmfConstant, unitOf("V s/rad").above(0), "Voltage per rate.");
        d.exactlyOneOf("SpeedConstant|BackEmfConstant", "TorqueConstant");
        d.field("Resistance", &Motor::resistance, ohms().above(0).required(), "Of the winding.");
        d.field("GearRatio", &Motor::gearRatio, number().above(0), "Motor turns per joint turn.");
        d.command("voltage", "V", "Voltage.");
    }
};

struct Drive {
    std::string left, right, control = "servo";
    double radius = 0;
    static void describe(Describe<Drive>& d) {
        d.help("A drive.");
        d.field("LeftMotor", &Drive::left, reference("RotaryMotor").required(), "The left motor.");
        d.field("RightMotor", &Drive::right, reference("RotaryMotor").required(), "The right motor.");
        d.field("WheelRadius", &Drive::radius, metres().above(0).required(), "Radius of the wheels.");
        d.field("Control", &Drive::control, oneOf("servo|pi|voltage"), "How it drives.");
    }
};

struct Touch {
    std::vector<std::string> geoms;
    double minForce = 0;
    static void describe(Describe<Touch>& d) {
        Quantity geom = reference("Geom").required();
        geom.minCount = 1;
        geom.maxCount = 100;
        d.field("Geom", &Touch::geoms, geom, "What it watches.");
        d.field("MinForce", &Touch::minForce, newtons().atLeast(0), "Smallest force.");
        d.output("pressed", "", "Touched.", 1, TRUNDLE_BOOLEAN_SIGNAL);
    }
};

struct Encoder {
    std::string joint;
    int counts = 512;
    bool quadrature = false;
    static void describe(Describe<Encoder>& d) {
        d.field("Joint", &Encoder::joint, reference("Hinge").required(), "Joint it reads.");
        d.field("CountsPerRevolution", &Encoder::counts, number().within(1, 1e6), "Resolution.");
        d.field("Quadrature", &Encoder::quadrature, flag(), "Counts each edge.");
    }
};

struct Camera {
    std::string body;
    std::array<double, 3> pos{}, hpr{};
    double nearPlane = 0.05, farPlane = 100;
    static void describe(Describe<Camera>& d) {
        d.field("Body", &Camera::body, reference("Body"), "It looks from.");
        d.field("Pos", &Camera::pos, metres(), "In the body.");
        d.field("HPR", &Camera::hpr, degrees(), "In the body.");
        d.field("Near", &Camera::nearPlane, metres().above(0), "What is nearer is not seen.");
        d.field("Far", &Camera::farPlane, metres().above(0), "What is farther is not seen.");
    }
};

struct Radio {
    std::string antenna = "isotropic";
    double maxOutputPower = 0, minReceivePower = -94, maxReceivePower = 0;
    int channel = 26, address = 0;
    std::vector<double> powerLevels, transmitCurrent;
    static void describe(Describe<Radio>& d) {
        d.field("Antenna", &Radio::antenna, reference("AntennaPattern"), "How it looks.");
        d.field("MaxOutputPower", &Radio::maxOutputPower, decibelMilliwatts().within(-100, 100), "At most.");
        d.field("MinReceivePower", &Radio::minReceivePower, decibelMilliwatts().within(-200, 100), "At least.");
        d.field("MaxReceivePower", &Radio::maxReceivePower, decibelMilliwatts().within(-200, 100), "Its RSSI ends here.");
        d.field("Channel", &Radio::channel, number().within(0, 26), "Which.");
        d.field("Address", &Radio::address, number().within(0, 65534), "Its own.");
        d.field("PowerLevels", &Radio::powerLevels, decibelMilliwatts().within(-100, 100).counted(0, 1000), "It has.");
        d.field("TransmitCurrent", &Radio::transmitCurrent, amperes().within(0, 100).counted(0, 1000), "For each.");
    }
};

struct PoseLog {
    std::vector<std::string> robots;
    double interval = 0.1;
    std::optional<std::string> file;
    static void describe(Describe<PoseLog>& d) {
        Quantity robot = reference("Robot").required();
        robot.minCount = 1;
        robot.maxCount = 100000;
        d.field("Robot", &PoseLog::robots, robot, "Whose pose.");
        d.field("Interval", &PoseLog::interval, seconds().above(0), "Time between rows.");
        d.field("File", &PoseLog::file, trundle::file("csv"), "Where it goes.");
    }
};

struct Walker {
    double speed = 0.2;
    std::string mood = "calm";
    static void describe(Describe<Walker>& d) {
        d.help("Walks.");
        d.field("Speed", &Walker::speed, metresPerSecond().within(0, 2), "Cruising speed.");
        d.field("Mood", &Walker::mood, oneOf("calm|wild"), "How it walks.");
    }
};

inline std::shared_ptr<const Registry> kinds() {
    auto registry = std::make_shared<Registry>();
    addModelKinds(*registry);
    bool good = registry->add(kindOf<Motor>("RotaryMotor", Role::Device, {"RobotConfig"})).ok();
    good = registry->add(kindOf<Drive>("DifferentialDrive", Role::Device, {"RobotConfig"})).ok() && good;
    good = registry->add(kindOf<Touch>("TouchSensor", Role::Device, {"RobotConfig"})).ok() && good;
    good = registry->add(kindOf<Encoder>("Encoder", Role::Device, {"RobotConfig"})).ok() && good;
    good = registry->add(kindOf<Camera>("Camera", Role::Device, {"RobotConfig"})).ok() && good;
    good = registry->add(kindOf<Radio>("Transceiver", Role::Device, {"RobotConfig"})).ok() && good;
    good = registry->add(kindOf<PoseLog>("PoseLog", Role::Log, {""}, true)).ok() && good;
    assert(good);
    (void)good;
    return registry;
}

/// A valid robot.
inline const char* kGoodRobot = R"(
Material grey { ColorRGB=0.5,0.5,0.5 }
Surface rubber { Friction=1 }
RobotConfig Rover {
  Param wheelRadius = 0.05
  Body chassis { Box hull { Size=0.3,0.2,0.1 Pos=0,0,0.09 Mass=2 Material=grey Surface=rubber } }
  Body leftWheel { Pos=0,0.1,$wheelRadius
    Cylinder tyre { Radius=$wheelRadius Length=0.03 HPR=0,0,90 Mass=0.15 Material=grey Surface=rubber } }
  Body rightWheel { Pos=0,-0.1,$wheelRadius
    Cylinder tyre { Radius=$wheelRadius Length=0.03 HPR=0,0,90 Mass=0.15 Material=grey Surface=rubber } }
  Hinge leftAxle { Parent=chassis Child=leftWheel Axis=0,2,0 }
  Hinge rightAxle { Parent=chassis Child=rightWheel Axis=0,1,0 }
  RotaryMotor leftMotor { Joint=leftAxle TorqueConstant=0.02 SpeedConstant=50 Resistance=2 }
  RotaryMotor rightMotor { Joint=rightAxle TorqueConstant=0.02 SpeedConstant=50 Resistance=2 }
  DifferentialDrive base { LeftMotor=leftMotor RightMotor=rightMotor WheelRadius=$wheelRadius }
  TouchSensor touch { Geom=chassis.hull }
}
)";

} // namespace sample
