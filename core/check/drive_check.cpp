#include <algorithm>
#include <cmath>
#include <set>

#include "check/checks.h"
#include "project/objects/part_values.h"

namespace trundle {

namespace {

constexpr double kTolerance = 0.02; // relative, for radius and separation
constexpr double kSameLine = 0.02;  // sine of the angle between a wheel's axis and its axle
constexpr std::string_view kDrive = "DifferentialDrive", kMotor = "RotaryMotor";

/// Geometry of a wheel, from its geom and joint.
struct Wheel {
    const GeomSpec* geom = nullptr;
    Vec3 centre = Vec3::Zero(), axis = Vec3::UnitY(); ///< in the config's frame
};

/// Checks all drives of one config.
class DriveCheck {
public:
    DriveCheck(const LoadedProject& loaded, const RobotConfigSpec& config, Diagnostics& diagnostics)
        : m_loaded(loaded), m_config(config), m_diagnostics(diagnostics) {}

    void check(const ComponentSpec& drive) {
        if (drive.text("LeftMotor") == drive.text("RightMotor")) return sameMotor(drive);
        const std::optional<Wheel> left = wheelOf(drive.text("LeftMotor")), right = wheelOf(drive.text("RightMotor"));
        if (!left || !right) return;
        const double radius = left->geom->radius;
        if (std::abs(right->geom->radius - radius) <= kTolerance * radius)
            compare(drive, "WheelRadius", radius,
                    "the wheels " + left->geom->name + " and " + right->geom->name + " have a radius of ", "distances");
        compare(drive, "WheelSeparation", std::abs((left->centre - right->centre).dot(left->axis)),
                "the middles of the wheels " + left->geom->name + " and " + right->geom->name + " are apart by ", "turns");
    }

private:
    /// Reports a drive that uses one motor twice; a run would refuse it.
    void sameMotor(const ComponentSpec& drive) {
        const ResolvedValue* right = drive.find("RightMotor");
        Diagnostic& d = m_diagnostics.error(Code::DeviceSetup, right->range.known() ? right->range : drive.nameRange,
                                            "LeftMotor and RightMotor of " + drive.name + " are the same motor, " +
                                                drive.text("LeftMotor") + "; each wheel needs one of its own");
        std::vector<std::string> others;
        for (const ComponentSpec& device : m_config.devices)
            if (device.kind == kMotor && device.name != drive.text("LeftMotor")) others.push_back(device.name);
        if (others.size() == 1 && canWrite(*right)) d.fixes.push_back({others[0], {{right->range, others[0]}}});
        d.suggestions = std::move(others);
    }

    /// The largest round geom of the motor's wheel that rotates about its axle.
    [[nodiscard]] std::optional<Wheel> wheelOf(const std::string& motor) const {
        const auto device = std::ranges::find(m_config.devices, motor, &ComponentSpec::name);
        if (device == m_config.devices.end()) return std::nullopt;
        const auto joint = std::ranges::find(m_config.joints, device->text("Joint"), &JointSpec::name);
        if (joint == m_config.joints.end()) return std::nullopt;
        const Vec3& axle = joint->type == JointType::Suspension ? joint->axis2 : joint->axis;
        const BodySpec& body = m_config.bodies[static_cast<std::size_t>(joint->child)];
        std::optional<Wheel> wheel;
        for (const GeomSpec& g : body.geoms) {
            const Pose pose = body.pose * g.pose;
            const bool round = g.shape == GeomShape::Sphere || g.shape == GeomShape::Cylinder;
            if (!g.collide || !round) continue;
            if (g.shape == GeomShape::Cylinder && (pose.rotation * Vec3::UnitZ()).cross(axle).norm() > kSameLine) continue;
            if (!wheel || g.radius > wheel->geom->radius) wheel = Wheel{&g, pose.position, axle};
        }
        return wheel;
    }

    void compare(const ComponentSpec& drive, const char* key, double real, const std::string& where, const char* effect) {
        const ResolvedValue* value = drive.find(key);
        const double given = drive.number(key);
        if (!value || !(real > 0) || std::abs(given - real) <= kTolerance * real) return;
        Diagnostic& d = m_diagnostics.warning(Code::WheelGeometry, value->range.known() ? value->range : drive.nameRange,
                                              std::string(key) + " of " + drive.name + " is " + lengthText(given) + ", but " +
                                                  where + lengthText(real) + ": " + effect + " will be " +
                                                  figureText(100 * std::abs(given / real - 1)) + " % off");
        const std::string text = shortNumber(std::round(real * 1e6) / 1e6);
        if (canWrite(*value)) d.fixes.push_back({std::string(key) + "=" + text, {{value->range, text}}});
    }

    /// Whether a value is literal text in a file, not set by a Param or on the command line.
    [[nodiscard]] bool canWrite(const ResolvedValue& value) const {
        const FileId file = value.range.file;
        if (!value.range.known() || file >= m_loaded.paths.size() || m_loaded.paths[file].empty()) return false;
        return m_loaded.sources.slice(value.range).find('$') == std::string_view::npos;
    }

    const LoadedProject& m_loaded;
    const RobotConfigSpec& m_config;
    Diagnostics& m_diagnostics;
};

/// Warns of motors that share a joint: a joint has one motor row, which the last of them sets.
void checkSharedJoints(const RobotConfigSpec& config, Diagnostics& diagnostics) {
    for (auto motor = config.devices.begin(); motor != config.devices.end(); ++motor) {
        if (motor->kind != kMotor) continue;
        const auto earlier = std::find_if(config.devices.begin(), motor, [&](const ComponentSpec& other) {
            return other.kind == kMotor && other.text("Joint") == motor->text("Joint");
        });
        if (earlier == motor) continue;
        const ResolvedValue* joint = motor->find("Joint");
        diagnostics.warning(Code::DeviceSetup, joint && joint->range.known() ? joint->range : motor->nameRange,
                            motor->name + " and " + earlier->name + " turn the same joint, " + motor->text("Joint") + ": only " +
                                motor->name +
                                " acts on it, and both report its torque; give each a joint of its own, or keep one of them");
    }
}

/// An encoder on a slider counts lines, whose pitch it needs; the lines of a disc have none.
void checkEncoders(const RobotConfigSpec& config, Diagnostics& diagnostics) {
    for (const ComponentSpec& encoder : config.devices) {
        if (encoder.kind != "Encoder") continue;
        const auto joint = std::ranges::find(config.joints, encoder.text("Joint"), &JointSpec::name);
        const ResolvedValue* pitch = encoder.find("Pitch");
        const bool hasPitch = pitch && !pitch->value.numbers.empty();
        if (joint == config.joints.end() || (joint->type == JointType::Slider) == hasPitch) continue;
        diagnostics.warning(Code::DeviceSetup, hasPitch && pitch->range.known() ? pitch->range : encoder.nameRange,
                            encoder.name + (hasPitch ? " has a Pitch, but " + joint->name + " is no Slider: its angle will be wrong"
                                                     : " is on the Slider " + joint->name + " and needs the Pitch of its lines"));
    }
}

} // namespace

void checkDrives(const LoadedProject& loaded, Diagnostics& diagnostics) {
    std::set<const RobotConfigSpec*> seen; // membership test only: its order, by address, must not affect the output
    for (const RobotSpec& robot : loaded.experiment->robots) {
        if (!robot.config || !seen.insert(robot.config.get()).second) continue;
        checkSharedJoints(*robot.config, diagnostics);
        checkEncoders(*robot.config, diagnostics);
        DriveCheck check(loaded, *robot.config, diagnostics);
        for (const ComponentSpec& device : robot.config->devices)
            if (device.kind == kDrive) check.check(device);
    }
}

} // namespace trundle
