#include <algorithm>
#include <cmath>
#include <set>
#include <unordered_map>

#include "check/checks.h"
#include "check/drive_directions.h"
#include "check/drive_wheels.h"
#include "project/objects/part_values.h"

namespace trundle {

namespace {

constexpr double kTolerance = 0.02; // relative, for radius and distances
constexpr std::string_view kMotor = "RotaryMotor";

/// Checks all drives of one config.
class DriveCheck {
public:
    DriveCheck(const LoadedProject& loaded, const RobotConfigSpec& config, Diagnostics& diagnostics)
        : m_loaded(loaded), m_config(config), m_diagnostics(diagnostics) {}

    void check(const ComponentSpec& drive) {
        const std::vector<DriveMotor> motors = motorsOf(drive);
        for (auto motor = motors.begin(); motor != motors.end(); ++motor)
            if (const auto earlier =
                    std::find_if(motors.begin(), motor, [&](const DriveMotor& m) { return m.name == motor->name; });
                earlier != motor)
                return sameMotor(drive, *earlier, *motor);
        std::vector<DriveWheel> wheels;
        for (const DriveMotor& motor : motors) {
            const auto wheel = wheelOf(m_config, motor.name);
            if (!wheel) return checkAxle(m_loaded, m_config, drive, motor, m_diagnostics);
            wheels.push_back(*wheel);
        }
        if (wheels.empty()) return;
        checkWheels(drive, motors, wheels);
        checkDirections(m_loaded, m_config, drive, motors, wheels, m_diagnostics);
    }

private:
    void checkWheels(const ComponentSpec& drive, const std::vector<DriveMotor>& motors, const std::vector<DriveWheel>& wheels) {
        const std::string names = "the wheels " + nameOf(wheels.front()) + " and " + nameOf(wheels.back());
        const auto radius = [](const DriveWheel& w) { return w.geom->radius; };
        if (const auto all = sameOf(wheels, radius))
            compare(drive, "WheelRadius", *all, names + " have a radius of ", "distances");
        const Vec3 across = wheels.front().axis, ahead = across.cross(Vec3::UnitZ());
        const auto apart = [&](const Vec3& direction, bool DriveMotor::*side) {
            std::array<double, 2> sums{}, counts{};
            for (std::size_t i = 0; i < wheels.size(); ++i) {
                sums[motors[i].*side] += wheels[i].centre.dot(direction);
                ++counts[motors[i].*side];
            }
            return std::abs(sums[0] / counts[0] - sums[1] / counts[1]); // not a number if all are on one side
        };
        if (drive.kind == "OmniDrive") {
            const auto distance = [](const DriveWheel& w) { return std::abs(w.centre.dot(w.axis)); };
            if (const auto all = sameOf(wheels, distance))
                compare(drive, "WheelDistance", *all, names + " are away from the middle by ", "turns");
            return;
        }
        compare(drive, "WheelSeparation", apart(across, &DriveMotor::isRight), "the middles of " + names + " are apart by ",
                "turns");
        if (drive.kind == "MecanumDrive")
            compare(drive, "WheelBase", apart(ahead, &DriveMotor::isBack), "the axles of " + names + " are apart by ", "turns");
        if (drive.kind == "AckermannDrive")
            if (const auto steered = steeredAnchor(drive))
                compare(drive, "WheelBase", std::abs((*steered - wheels.front().centre).dot(ahead.normalized())),
                        "the steered wheels are ahead of the driven ones by ", "curves");
    }

    /// Names the geom, and its body where another wheel has a geom of that name.
    [[nodiscard]] std::string nameOf(const DriveWheel& wheel) const {
        const std::string& name = wheel.geom->name;
        int same = 0;
        for (const BodySpec& body : m_config.bodies)
            same += static_cast<int>(std::ranges::count(body.geoms, name, &GeomSpec::name));
        return same > 1 ? m_config.bodies[wheel.body].name : name;
    }

    /// The value of all wheels; nothing if they differ.
    template <class Of> [[nodiscard]] static std::optional<double> sameOf(const std::vector<DriveWheel>& wheels, Of of) {
        const double first = of(wheels.front());
        for (const DriveWheel& wheel : wheels)
            if (!(std::abs(of(wheel) - first) <= kTolerance * first)) return std::nullopt;
        return first;
    }

    /// Of the axis about which the left front wheel is steered.
    [[nodiscard]] std::optional<Vec3> steeredAnchor(const ComponentSpec& drive) const {
        const auto servo = std::ranges::find(m_config.devices, drive.text("LeftSteering"), &ComponentSpec::name);
        if (servo == m_config.devices.end()) return std::nullopt;
        const auto joint = std::ranges::find(m_config.joints, servo->text("Joint"), &JointSpec::name);
        return joint == m_config.joints.end() ? std::nullopt : std::optional(joint->anchor);
    }

    /// Reports a drive that uses one motor twice; a run would refuse it.
    void sameMotor(const ComponentSpec& drive, const DriveMotor& first, const DriveMotor& second) {
        const SourceRange& range = second.value->range;
        const bool isOneKey = first.value == second.value;
        Diagnostic& d =
            m_diagnostics.error(Code::DeviceSetup, range.known() ? range : drive.nameRange,
                                isOneKey ? std::string(second.key) + " of " + drive.name + " names the motor " + second.name +
                                               " twice; each wheel needs one of its own"
                                         : std::string(first.key) + " and " + second.key + " of " + drive.name +
                                               " are the same motor, " + second.name + "; each wheel needs one of its own");
        std::vector<std::string> others;
        const std::vector<DriveMotor> used = motorsOf(drive);
        for (const ComponentSpec& device : m_config.devices)
            if (device.kind == kMotor && std::ranges::find(used, device.name, &DriveMotor::name) == used.end())
                others.push_back(device.name);
        if (others.size() == 1 && second.value->value.texts.size() == 1 && isWritten(m_loaded, *second.value))
            d.fixes.push_back({others[0], {{range, others[0]}}});
        d.suggestions = std::move(others);
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
        if (isWritten(m_loaded, *value)) d.fixes.push_back({std::string(key) + "=" + text, {{value->range, text}}});
    }

    const LoadedProject& m_loaded;
    const RobotConfigSpec& m_config;
    Diagnostics& m_diagnostics;
};

bool turnsJoint(const ComponentSpec& device) { return device.kind == kMotor || device.kind == "Servo" || device.kind == "LinearMotor"; }

/// Warns of motors that share a joint: a joint has one motor row, which the last of them sets.
void checkSharedJoints(const RobotConfigSpec& config, Diagnostics& diagnostics) {
    std::unordered_map<std::string, const ComponentSpec*> firsts; // by joint
    for (const ComponentSpec& motor : config.devices) {
        if (!turnsJoint(motor)) continue;
        const auto [earlier, isFirst] = firsts.try_emplace(motor.text("Joint"), &motor);
        if (isFirst) continue;
        const ResolvedValue* joint = motor.find("Joint");
        diagnostics.warning(Code::DeviceSetup, joint && joint->range.known() ? joint->range : motor.nameRange,
                            motor.name + " and " + earlier->second->name + " move the same joint, " + earlier->first + ": only " +
                                motor.name +
                                " acts on it, and both report its torque; give each a joint of its own, or keep one of them");
    }
}

/// An encoder on a slider counts lines, whose pitch it needs; the lines of a disc have none.
void checkEncoders(const RobotConfigSpec& config, Diagnostics& diagnostics) {
    std::unordered_map<std::string_view, const JointSpec*> joints;
    for (const JointSpec& joint : config.joints) joints.try_emplace(joint.name, &joint);
    for (const ComponentSpec& encoder : config.devices) {
        if (encoder.kind != "Encoder") continue;
        const std::string name = encoder.text("Joint");
        const auto joint = joints.find(name);
        const ResolvedValue* pitch = encoder.find("Pitch");
        const bool hasPitch = pitch && !pitch->value.numbers.empty();
        if (joint == joints.end() || (joint->second->type == JointType::Slider) == hasPitch) continue;
        diagnostics.warning(Code::DeviceSetup, hasPitch && pitch->range.known() ? pitch->range : encoder.nameRange,
                            encoder.name + (hasPitch ? " has a Pitch, but " + name + " is no Slider: its angle will be wrong"
                                                     : " is on the Slider " + name + " and needs the Pitch of its lines"));
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
        for (const ComponentSpec& device : robot.config->devices) check.check(device);
    }
}

} // namespace trundle
