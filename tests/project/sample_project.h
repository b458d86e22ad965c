#pragma once
// A project with sample kinds, a module catalog and meshes defined here: core/project depends only on their interfaces.

#include <filesystem>
#include <fstream>

#include <QTemporaryDir>

#include "lang/diagnostic_text.h"
#include "model/model_kinds.h"
#include "project/project.h"

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
    double nearPlane = 0.05, farPlane = 100;
    static void describe(Describe<Camera>& d) {
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

class Catalog final : public ModuleCatalog {
public:
    Result<ModuleListing> find(const std::string& written, const std::string&) override {
        if (written == "walker" || written == "Controllers/walker.dll") return listing("/modules/libwalker.so", {"Walker"});
        if (written == "other_walker") return listing("/modules/libother.so", {"Walker"});
        if (written == "controllers/prowler") return listing("/modules/controllers/libprowler.so", {"Prowler"});
        if (written == "mystery") return ModuleListing{"/modules/libmystery.so", false, {}};
        if (written == "untrusted") return Error{Code::ModuleNotTrusted, "the folder of untrusted is not trusted"};
        return Error{Code::ModuleNotFound, written + " is not found; tried /modules/lib" + written + ".so"};
    }
    std::string moduleWith(const std::string& kind) override { return kind == "Prowler" ? "controllers/prowler" : ""; }

private:
    static ModuleListing listing(std::string library, const std::vector<std::string>& names) {
        ModuleListing l{std::move(library), true, {}};
        for (const std::string& name : names)
            l.kinds.push_back(kindOf<Walker>(name, Role::Controller, {"Robot", "Grid", "Scatter"}));
        return l;
    }
};

/// The file name selects the shape.
class Meshes final : public MeshSource {
public:
    Result<std::shared_ptr<const TriangleMesh>> mesh(const std::string& path) override {
        auto cube = std::make_shared<TriangleMesh>();
        for (int i = 0; i < 8; ++i) cube->points.push_back({i & 1 ? 1.0 : 0.0, i & 2 ? 1.0 : 0.0, i & 4 ? 1.0 : 0.0});
        cube->triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                           {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
        const std::string name = std::filesystem::path(path).filename().string();
        if (name == "bad.obj") return Error{Code::MeshUnreadable, "bad.obj cannot be read: it holds no mesh"};
        if (name == "open.obj") cube->triangles.pop_back();
        if (name == "flat.obj")
            for (auto& p : cube->points) p[2] = 0;
        if (name == "far.obj") cube->points[7][0] = 1e9;
        return std::shared_ptr<const TriangleMesh>(cube);
    }
    Result<std::shared_ptr<const HeightMap>> heightMap(const std::string& path) override {
        if (path.ends_with("tiny.png")) return std::make_shared<const HeightMap>(HeightMap{1, 1, {0.5f}});
        return std::make_shared<const HeightMap>(HeightMap{2, 2, {0, 1, 0, 1}});
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

/// Opens texts in a temporary folder.
class ProjectFixture {
public:
    std::string folder() const { return m_dir.path().toStdString(); }
    std::string write(const std::string& name, const std::string& text) const {
        const std::filesystem::path path = std::filesystem::path(folder()) / name;
        std::filesystem::create_directories(path.parent_path());
        std::ofstream(path, std::ios::binary) << text;
        return path.string();
    }
    Result<std::shared_ptr<const LoadedProject>> tryOpen(const std::string& path) {
        Project project(kinds(), m_catalog, m_meshes, options);
        return project.open(path);
    }
    std::shared_ptr<const LoadedProject> open(const std::string& text) { return openFile(write("main.sim", text)); }
    std::shared_ptr<const LoadedProject> openFile(const std::string& path) {
        auto result = tryOpen(path);
        return result.ok() ? result.value() : nullptr;
    }
    ProjectOptions options;

private:
    QTemporaryDir m_dir;
    Catalog m_catalog;
    Meshes m_meshes;
};

inline std::string rendered(const LoadedProject& loaded) {
    std::string all;
    for (const Diagnostic& d : loaded.diagnostics.all()) all += render(d, loaded.sources);
    return all;
}

/// The messages alone, one a line: "E203 Radius is -3 cm, it must be above 0".
inline std::string messages(const LoadedProject& loaded) {
    std::string all;
    for (const Diagnostic& d : loaded.diagnostics.all()) all += codeName(d.code) + " " + d.message + "\n";
    return all;
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
