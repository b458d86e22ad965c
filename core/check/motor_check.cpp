// Motors and encoders: which joints they are on, and whether those of both sides are alike.
#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "check/checks.h"
#include "check/drive_wheels.h"

namespace trundle {

namespace {

constexpr double kLeastPower = 0.3, kMostPower = 2; // times that taken
constexpr double kUnlike = 1.5;                     // between torques or speeds of both sides
constexpr double kAlongJaws = 0.5;                  // cosine, between a slider and the way to the other jaw
constexpr double kOneValue = 1.2;                   // between values that make them so

bool turnsJoint(const ComponentSpec& device) {
    return device.kind == "RotaryMotor" || device.kind == "Servo" || device.kind == "LinearMotor";
}

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

/// The jaws of a Gripper open at a positive position of their sliders.
void checkJaws(const RobotConfigSpec& config, Diagnostics& diagnostics) {
    const auto sliderOf = [&](const std::string& name) { return std::ranges::find(config.joints, name, &JointSpec::name); };
    const auto middleOf = [&](int index) {
        const BodySpec& body = config.bodies[static_cast<std::size_t>(index)];
        return body.pose * body.mass.centre;
    };
    for (const ComponentSpec& gripper : config.devices) {
        if (gripper.kind != "Gripper") continue;
        const auto left = sliderOf(gripper.text("Left")), right = sliderOf(gripper.text("Right"));
        if (left == config.joints.end() || right == config.joints.end() || left->child == right->child) continue;
        const Vec3 apart = middleOf(left->child) - middleOf(right->child);
        for (const auto& [slider, out] : {std::pair(left, apart), std::pair(right, Vec3(-apart))}) {
            if (slider->axis.dot(out.normalized()) > -kAlongJaws) continue; // opens, or moves across the other one
            diagnostics.warning(Code::DeviceSetup, slider->nameRange,
                                slider->name + " moves its jaw towards the other one at a positive position, at which " +
                                    gripper.name + " takes it for open; reverse its Axis");
            return;
        }
    }
}

/// Two encoders count one joint, and none counts another motor's.
void checkTwins(const RobotConfigSpec& config, Diagnostics& diagnostics) {
    std::unordered_map<std::string, const ComponentSpec*> firsts; // by joint
    for (const ComponentSpec& encoder : config.devices) {
        if (encoder.kind != "Encoder") continue;
        const auto [earlier, isFirst] = firsts.try_emplace(encoder.text("Joint"), &encoder);
        if (isFirst || encoder.text("Type") != earlier->second->text("Type")) continue; // a coarse and an absolute one
        const auto isCounted = [&](const ComponentSpec& motor) {
            return std::ranges::any_of(config.devices, [&](const ComponentSpec& d) {
                return d.kind == "Encoder" && d.text("Joint") == motor.text("Joint");
            });
        };
        const auto other = std::ranges::find_if(config.devices,
                                                [&](const ComponentSpec& d) { return d.kind == "RotaryMotor" && !isCounted(d); });
        if (other == config.devices.end()) continue;
        const ResolvedValue* joint = encoder.find("Joint");
        Diagnostic& d =
            diagnostics.warning(Code::DeviceSetup, joint && joint->range.known() ? joint->range : encoder.nameRange,
                                encoder.name + " and " + earlier->second->name + " count the same joint, " + earlier->first +
                                    ", and no encoder counts " + other->text("Joint") + ", which " + other->name + " turns");
        d.suggestions.push_back(other->text("Joint"));
    }
}

/// The value in which two motors differ most.
std::string differenceOf(const ComponentSpec& one, const ComponentSpec& two) {
    double most = kOneValue;
    std::string text;
    for (const char* key :
         {"GearRatio", "MaxVoltage", "TorqueConstant", "SpeedConstant", "BackEmfConstant", "Resistance", "Efficiency"}) {
        const double a = one.number(key), b = two.number(key);
        const double ratio = a > 0 && b > 0 ? std::max(a / b, b / a) : 0;
        if (ratio <= most) continue;
        most = ratio;
        text = std::string(": its ") + key + " is " + figureText(b) + ", that of " + one.name + " " + figureText(a);
    }
    return text;
}

/// Motors in the same place of both sides that have other torques or speeds.
void checkAlike(const RobotConfigSpec& config, const ComponentSpec& drive, Diagnostics& diagnostics) {
    const std::vector<DriveMotor> motors = motorsOf(drive);
    const auto deviceOf = [&](const DriveMotor& motor) {
        return std::ranges::find(config.devices, motor.name, &ComponentSpec::name);
    };
    for (auto left = motors.begin(); left != motors.end(); ++left) {
        const auto isAcross = [&](const DriveMotor& m) {
            return m.isRight && !left->isRight && m.isBack == left->isBack && m.index == left->index;
        };
        const auto right = drive.kind == "OmniDrive" ? motors.begin() : std::ranges::find_if(motors, isAcross);
        if (right == motors.end() || right == left) continue;
        auto one = deviceOf(*left), two = deviceOf(*right);
        if (one == config.devices.end() || two == config.devices.end()) continue;
        DriveWheel a, b;
        a.motor = &*one, b.motor = &*two;
        const auto isUnlike = [](double x, double y) { return std::max(x, y) > kUnlike * std::min(x, y); };
        const bool isWeaker = isUnlike(a.stallTorque(), b.stallTorque());
        if (!isWeaker && !isUnlike(a.topRate(), b.topRate())) continue;
        if (isWeaker ? a.stallTorque() < b.stallTorque() : a.topRate() > b.topRate())
            std::swap(one, two), std::swap(a, b); // the odd one
        diagnostics.warning(Code::WeakMotor, two->nameRange,
                            two->name + " of " + drive.name + " turns at up to " + figureText(b.topRate()) +
                                " rad/s with up to " + figureText(b.stallTorque()) + " N m, " + one->name + " at up to " +
                                figureText(a.topRate()) + " rad/s with up to " + figureText(a.stallTorque()) + " N m" +
                                differenceOf(*one, *two));
        return;
    }
}

/// By its constants a motor gives TorqueConstant x SpeedConstant times the power that it takes, without its losses: 1 but for rounding.
void checkConstants(const RobotConfigSpec& config, Diagnostics& diagnostics) {
    for (const ComponentSpec& motor : config.devices) {
        if (motor.kind != "RotaryMotor") continue;
        const double bemf = motor.number("BackEmfConstant"), perVolt = motor.find("SpeedConstant") ? motor.number("SpeedConstant")
                                                                       : bemf > 0                  ? 1 / bemf
                                                                                                   : 0;
        const double power = motor.number("TorqueConstant") * perVolt;
        if (!(power > 0) || (power >= kLeastPower && power <= kMostPower)) continue;
        const ResolvedValue* value = motor.find("TorqueConstant");
        const std::string other = motor.find("SpeedConstant") ? "SpeedConstant, " + figureText(perVolt) + " rad/s/V"
                                                              : "BackEmfConstant, " + figureText(bemf) + " Vs/rad";
        diagnostics.warning(
            Code::WeakMotor, value && value->range.known() ? value->range : motor.nameRange,
            "TorqueConstant of " + motor.name + ", " + figureText(motor.number("TorqueConstant")) + " Nm/A, does not fit its " +
                other + ": it would give " + figureText(power) +
                " times the power that it takes; in these units each is 1 divided by the other, or both are equal");
    }
}

/// Drives that command the same motor: the last one acts on it.
void checkSharedMotors(const RobotConfigSpec& config, Diagnostics& diagnostics) {
    std::unordered_map<std::string, const ComponentSpec*> firsts; // by motor
    for (const ComponentSpec& drive : config.devices)
        for (const DriveMotor& motor : motorsOf(drive)) {
            const auto [earlier, isFirst] = firsts.try_emplace(motor.name, &drive);
            if (isFirst || earlier->second == &drive) continue;
            diagnostics.warning(Code::DeviceSetup, motor.place().known() ? motor.place() : drive.nameRange,
                                drive.name + " and " + earlier->second->name + " command the same motor, " + motor.name +
                                    ": only one of them acts on it; give each motors of its own");
            return;
        }
}

} // namespace

void checkMotors(const RobotConfigSpec& config, Diagnostics& diagnostics) {
    checkSharedJoints(config, diagnostics);
    checkEncoders(config, diagnostics);
    checkTwins(config, diagnostics);
    checkJaws(config, diagnostics);
    checkConstants(config, diagnostics);
    checkSharedMotors(config, diagnostics);
    for (const ComponentSpec& device : config.devices) checkAlike(config, device, diagnostics);
}

} // namespace trundle
