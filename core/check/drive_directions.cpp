// Which way a drive's wheels turn. Method: a positive rate about an axle moves the base along axle x up, so with all axles to its left it
// drives ahead; those of an OmniDrive point to the middle, so that it turns left.
#include "check/drive_directions.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "check/checks.h"
#include "project/edits/value_edits.h"
#include "project/objects/part_values.h"

namespace trundle {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kAlong = 0.02;      // sine of the angle between an axle and the axis of a wheel, as for WheelRadius
constexpr double kBeside = 1e-3, kBesideShare = 0.02; // m, and of the radius: of an axle from the middle of its wheel
constexpr double kApart = 1e-6;      // m, from the middle between the sides
constexpr double kOff = 2 * kDegree; // between WheelAngles and the wheels

struct SidePair {
    const char *left, *right; ///< keys of the drive
};

std::string axisText(const Vec3& axis) {
    return positionText(axis.unaryExpr([](double v) { return std::round(v * 1e6) / 1e6 + 0.; }));
}

class Directions {
public:
    Directions(const LoadedProject& loaded, const RobotConfigSpec& config, const ComponentSpec& drive, Diagnostics& diagnostics)
        : m_loaded(loaded), m_config(config), m_drive(drive), m_diagnostics(diagnostics) {}

    void check(const std::vector<DriveMotor>& motors, const std::vector<DriveWheel>& wheels) {
        for (const DriveWheel& wheel : wheels)
            if (const JointSpec* joint = jointOf(wheel); joint && reportedBeside(*joint, wheel)) return;
        if (m_drive.kind == "OmniDrive") return checkOmni(wheels);
        const Vec3 left = wheels.front().axis; // where the drive ahead is along left x up
        if (std::abs(left.z()) > 0.5) return;
        std::vector<DriveWheel> against;
        for (const DriveWheel& wheel : wheels)
            if (wheel.axis.dot(left) < 0) against.push_back(wheel);
        if (!against.empty()) return reportAgainst(wheels, against, left);
        const bool haveSides = std::ranges::any_of(motors, &DriveMotor::isRight);
        const auto isBeside = [&](const DriveWheel& w) {
            return std::abs((w.centre - wheels.front().centre).dot(left)) > kApart;
        };
        if (haveSides && std::ranges::none_of(wheels, isBeside)) return reportNoSides(motors, wheels);
        double middle = 0; // m, towards the left
        for (const DriveWheel& wheel : wheels) middle += wheel.centre.dot(left) / static_cast<double>(wheels.size());
        std::vector<std::size_t> wrong; // on the other side
        for (std::size_t i = 0; i < wheels.size(); ++i)
            if ((wheels[i].centre.dot(left) - middle) * (motors[i].isRight ? -1 : 1) < -kApart) wrong.push_back(i);
        if (wrong.size() == wheels.size()) return left.y() < -0.5 ? reportBackwards(wheels) : reportSides(motors, wheels);
        if (!wrong.empty()) return reportSide(motors[wrong.front()], wheels[wrong.front()]);
        if (m_drive.kind == "MecanumDrive") {
            double ahead = 0; // m, from the back wheels to the front ones, twice
            for (std::size_t i = 0; i < wheels.size(); ++i)
                ahead += (motors[i].isBack ? -1 : 1) * wheels[i].centre.dot(left.cross(Vec3::UnitZ()));
            if (ahead < 0) return reportFront();
            checkRollers(motors, wheels);
        }
        if (m_drive.kind == "AckermannDrive") checkSteering(left);
    }

    void checkAxle(const DriveMotor& motor) {
        const auto device = std::ranges::find(m_config.devices, motor.name, &ComponentSpec::name);
        if (device == m_config.devices.end()) return;
        const auto joint = std::ranges::find(m_config.joints, device->text("Joint"), &JointSpec::name);
        if (joint == m_config.joints.end() || (joint->type != JointType::Hinge && joint->type != JointType::Suspension)) return;
        if (joint->child == 0) return; // the chassis
        if (isGeared(m_config, *joint)) return;
        const BodySpec& body = m_config.bodies[static_cast<std::size_t>(joint->child)];
        const GeomSpec* largest = nullptr;
        for (const GeomSpec& geom : body.geoms) {
            if (!geom.collide) continue;
            if (geom.shape != GeomShape::Cylinder) return; // another shape may be what it stands on
            if (!largest || geom.radius > largest->radius) largest = &geom;
        }
        if (!largest) return;
        const bool isSprung = joint->type == JointType::Suspension;
        const Vec3 axis = isSprung ? joint->axis2 : joint->axis,
                   along = body.pose.rotation * (largest->pose.rotation * Vec3::UnitZ());
        if (along.cross(axis).norm() <= kAlong) return;
        const Vec3 rolling = along.y() < -0.5 || (std::abs(along.y()) <= 0.5 && along.sum() < 0) ? Vec3(-along) : along;
        const std::string text = std::string(isSprung ? "Axis2=" : "Axis=") + axisText(rolling);
        Diagnostic& d = m_diagnostics.warning(Code::WheelGeometry, joint->nameRange,
                                              joint->name + ", which " + motor.name + " of " + m_drive.name +
                                                  " turns, is not along the axis of " + body.name + "'s " + largest->name +
                                                  ": the wheel does not roll; its axis is that of " + text);
        addAxisFix(d, text, {&*joint}, {rolling});
    }

private:
    [[nodiscard]] const JointSpec* jointOf(const DriveWheel& wheel) const {
        const auto joint = std::ranges::find(m_config.joints, wheel.motor->text("Joint"), &JointSpec::name);
        return joint == m_config.joints.end() ? nullptr : &*joint;
    }
    [[nodiscard]] std::string bodyOf(const DriveWheel& wheel) const { return m_config.bodies[wheel.body].name; }

    /// Sets the axes of joints. Not of those in a Part or Repeat, whose text may be that of several.
    void addAxisFix(Diagnostic& d, const std::string& title, const std::vector<const JointSpec*>& joints,
                    const std::vector<Vec3>& axes) {
        std::vector<ValueEdit> values;
        for (std::size_t i = 0; i < joints.size(); ++i) {
            if (!joints[i] || joints[i]->name.find('.') != std::string::npos) return;
            const char* key = joints[i]->type == JointType::Suspension ? ".Axis2" : ".Axis";
            values.push_back(
                {DottedPath("RobotConfig." + m_config.name + "." + joints[i]->name + key), ParsedValue(axisText(axes[i]))});
        }
        const auto edits = editsForValues(m_loaded, values);
        if (edits.ok() && edits.value().size() == 1) d.fixes.push_back({title, edits.value().begin()->second});
    }
    void addReversal(Diagnostic& d, const std::vector<DriveWheel>& wheels) {
        std::vector<const JointSpec*> joints;
        std::vector<Vec3> axes;
        for (const DriveWheel& wheel : wheels) {
            const JointSpec* joint = jointOf(wheel);
            if (!joint) return;
            joints.push_back(joint), axes.push_back(joint->type == JointType::Suspension ? -joint->axis2 : -joint->axis);
        }
        addAxisFix(d, wheels.size() == 1 ? "reverse the axis" : "reverse their axes", joints, axes);
    }

    /// Some axles point the other way: those that point right are meant, or the fewer ones.
    void reportAgainst(const std::vector<DriveWheel>& wheels, std::vector<DriveWheel> against, const Vec3& left) {
        std::vector<DriveWheel> others;
        for (const DriveWheel& wheel : wheels)
            if (wheel.axis.dot(left) >= 0) others.push_back(wheel);
        if (std::abs(left.y()) > 0.5 ? left.y() < 0 : others.size() < against.size()) std::swap(against, others);
        const JointSpec* joint = jointOf(against.front());
        if (!joint) return;
        Diagnostic& d = m_diagnostics.warning(Code::WheelGeometry, joint->nameRange,
                                              joint->name + ", the axle of " + bodyOf(against.front()) +
                                                  ", points the other way than that of " + bodyOf(others.front()) +
                                                  ": at one speed of both, " + m_drive.name +
                                                  " turns the robot instead of driving it; reverse the axis of " + joint->name);
        addReversal(d, against);
    }

    void reportBackwards(const std::vector<DriveWheel>& wheels) {
        const JointSpec* joint = jointOf(wheels.front());
        if (!joint) return;
        Diagnostic& d = m_diagnostics.warning(
            Code::WheelGeometry, joint->nameRange,
            "the axles of " + bodyOf(wheels.front()) + " and " + bodyOf(wheels.back()) + " point to the right: " + m_drive.name +
                " drives backwards at a positive speed, and turns the other way; reverse their axes");
        addReversal(d, wheels);
    }

    void reportSides(const std::vector<DriveMotor>& motors, const std::vector<DriveWheel>& wheels) {
        const auto right = std::ranges::find(motors, true, &DriveMotor::isRight);
        const DriveMotor& left = motors.front();
        reportSwapped({left.key, right->key}, bodyOf(wheels.front()) + ", which " + left.name + " turns, is");
    }

    /// A wheel whose axle does not go through its middle.
    bool reportedBeside(const JointSpec& joint, const DriveWheel& wheel) {
        const double beside = (wheel.centre - joint.anchor).cross(wheel.axis).norm();
        if (beside <= std::max(kBeside, kBesideShare * wheel.geom->radius)) return false;
        m_diagnostics.warning(Code::WheelGeometry, joint.nameRange,
                              joint.name + ", the axle of " + bodyOf(wheel) + ", is " + lengthText(beside) +
                                  " beside the middle of its " + wheel.geom->name +
                                  ": it turns out of round; without an Anchor it is at the origin of " + bodyOf(wheel));
        return true;
    }

    void reportNoSides(const std::vector<DriveMotor>& motors, const std::vector<DriveWheel>& wheels) {
        const auto right = static_cast<std::size_t>(std::ranges::find(motors, true, &DriveMotor::isRight) - motors.begin());
        m_diagnostics.warning(Code::WheelGeometry, m_config.bodies[wheels[right].body].nameRange,
                              bodyOf(wheels[right]) + " is as far to the side as " + bodyOf(wheels.front()) + ": " +
                                  m_drive.name + " cannot turn the robot; check the sign of its Pos");
    }

    void reportSide(const DriveMotor& motor, const DriveWheel& wheel) {
        m_diagnostics.warning(Code::WheelGeometry, motor.value->range.known() ? motor.value->range : m_drive.nameRange,
                              bodyOf(wheel) + ", which " + motor.name + " turns, is on the " +
                                  (motor.isRight ? "left" : "right") + ", but " + motor.key + " of " + m_drive.name +
                                  " names it: turns will go wrong");
    }

    void reportSwapped(const SidePair& keys, const std::string& what) {
        const ResolvedValue *left = m_drive.find(keys.left), *right = m_drive.find(keys.right);
        if (!left || !right) return;
        Diagnostic& d =
            m_diagnostics.warning(Code::WheelGeometry, left->range.known() ? left->range : m_drive.nameRange,
                                  what + " on the right, but " + keys.left + " of " + m_drive.name +
                                      " names it: turns will go the other way; swap " + keys.left + " and " + keys.right);
        if (!isWritten(m_loaded, *left) || !isWritten(m_loaded, *right) || left->range.file != right->range.file) return;
        d.fixes.push_back({std::string("swap ") + keys.left + " and " + keys.right,
                           {{left->range, std::string(m_loaded.sources.slice(right->range))},
                            {right->range, std::string(m_loaded.sources.slice(left->range))}}});
    }

    void reportFront() {
        const ResolvedValue* front = m_drive.find("FrontLeftMotor");
        m_diagnostics.warning(Code::WheelGeometry, front && front->range.known() ? front->range : m_drive.nameRange,
                              "the wheels that the front motors of " + m_drive.name +
                                  " turn are at the back: its motion will be wrong; swap the front and the back motors");
    }

    /// Those at the front left and the back right lie one way, the others the other way.
    void checkRollers(const std::vector<DriveMotor>& motors, const std::vector<DriveWheel>& wheels) {
        for (std::size_t i = 0; i < wheels.size(); ++i) {
            const double heading = m_loaded.experiment->surfaces[wheels[i].geom->surface].frictionHeading;
            const double right = motors[i].isRight == motors[i].isBack ? -45 : 45;
            if (std::sin(2 * heading) * right >= 0) continue;
            m_diagnostics.warning(Code::WheelGeometry, wheels[i].geom->nameRange,
                                  "the rollers of " + bodyOf(wheels[i]) + " lie across those that " + m_drive.name +
                                      " needs there: the FrictionHeading of its Surface is " + degreesText(heading) +
                                      " degrees, not " + shortNumber(right) +
                                      "; -45 is for front left and back right, 45 for the others");
            return;
        }
    }

    void checkSteering(const Vec3& left) {
        const auto anchorOf = [&](const char* key) -> std::optional<Vec3> {
            const auto servo = std::ranges::find(m_config.devices, m_drive.text(key), &ComponentSpec::name);
            if (servo == m_config.devices.end()) return std::nullopt;
            const auto joint = std::ranges::find(m_config.joints, servo->text("Joint"), &JointSpec::name);
            return joint == m_config.joints.end() ? std::nullopt : std::optional(joint->anchor);
        };
        const auto onLeft = anchorOf("LeftSteering"), onRight = anchorOf("RightSteering");
        if (onLeft && onRight && (*onLeft - *onRight).dot(left) < 0)
            reportSwapped({"LeftSteering", "RightSteering"}, "the wheel that " + m_drive.text("LeftSteering") + " steers is");
    }

    void checkOmni(const std::vector<DriveWheel>& wheels) {
        Vec3 middle = Vec3::Zero();
        for (const DriveWheel& wheel : wheels) middle += wheel.centre / static_cast<double>(wheels.size());
        std::vector<DriveWheel> outward;
        for (const DriveWheel& wheel : wheels)
            if (wheel.axis.dot(wheel.centre - middle) > 0) outward.push_back(wheel);
        if (!outward.empty()) {
            const JointSpec* joint = jointOf(outward.front());
            if (!joint) return;
            Diagnostic& d = m_diagnostics.warning(
                Code::WheelGeometry, joint->nameRange,
                joint->name + ", the axle of " + bodyOf(outward.front()) + ", points away from the middle: " + m_drive.name +
                    " turns its wheel the wrong way" +
                    (outward.size() > 1 ? " (and " + std::to_string(outward.size() - 1) + " more like it)" : std::string()) +
                    "; reverse its axis");
            return addReversal(d, outward);
        }
        const ResolvedValue* given = m_drive.find("WheelAngles");
        const std::vector<double> angles = given ? given->value.numbers : std::vector<double>();
        if (!angles.empty() && angles.size() != wheels.size()) return; // a run refuses it
        std::string right;
        const DriveWheel* wrong = nullptr;
        double said = 0;
        for (std::size_t i = 0; i < wheels.size(); ++i) {
            const double even = kPi * static_cast<double>(2 * i + 1) / static_cast<double>(wheels.size());
            const double is = angleOf(wheels[i]), has = angles.empty() ? even : angles[i];
            if (!wrong && std::abs(std::remainder(is - has, 2 * kPi)) > kOff) wrong = &wheels[i], said = has;
            right += (i ? "," : "") + degreesText(is);
        }
        if (!wrong) return;
        const SourceRange range = given && given->range.known() ? given->range : m_drive.nameRange;
        Diagnostic& d = m_diagnostics.warning(Code::WheelGeometry, range,
                                              (angles.empty() ? m_drive.name + ", which has no WheelAngles, takes "
                                                              : "WheelAngles of " + m_drive.name + " takes ") +
                                                  bodyOf(*wrong) + " for a wheel at " + degreesText(said) +
                                                  " degrees, but it is at " + degreesText(angleOf(*wrong)) + ": " + m_drive.name +
                                                  " will move askew; WheelAngles=" + right + " are its angles");
        if (given && isWritten(m_loaded, *given)) d.fixes.push_back({"WheelAngles=" + right, {{given->range, right}}});
    }
    /// Of the wheel's place around the middle, rad, from 0 to 2 pi.
    static double angleOf(const DriveWheel& wheel) {
        const double angle = std::atan2(-wheel.axis.y(), -wheel.axis.x());
        return angle < -1e-9 ? angle + 2 * kPi : angle;
    }
    static std::string degreesText(double radians) { return shortNumber(std::round(radians / kDegree * 100) / 100 + 0.); }

    const LoadedProject& m_loaded;
    const RobotConfigSpec& m_config;
    const ComponentSpec& m_drive;
    Diagnostics& m_diagnostics;
};

} // namespace

bool isWritten(const LoadedProject& loaded, const ResolvedValue& value) {
    const FileId file = value.range.file;
    if (!value.range.known() || file >= loaded.paths.size() || loaded.paths[file].empty()) return false;
    return loaded.sources.slice(value.range).find('$') == std::string_view::npos;
}

void checkDirections(const LoadedProject& loaded, const RobotConfigSpec& config, const ComponentSpec& drive,
                     const std::vector<DriveMotor>& motors, const std::vector<DriveWheel>& wheels, Diagnostics& diagnostics) {
    Directions(loaded, config, drive, diagnostics).check(motors, wheels);
}

void checkAxle(const LoadedProject& loaded, const RobotConfigSpec& config, const ComponentSpec& drive, const DriveMotor& motor,
               Diagnostics& diagnostics) {
    Directions(loaded, config, drive, diagnostics).checkAxle(motor);
}

} // namespace trundle
