// Axles that are not along the axis of their wheel: which of both is level is taken for what is meant.
#include <algorithm>
#include <cmath>

#include "check/drive_directions.h"
#include "project/edits/value_edits.h"

namespace trundle {

namespace {

constexpr double kAlong = 0.02;                 // sine of the angle between an axle and the axis of a wheel, as for WheelRadius
constexpr double kAcross = 0.3;                 // the same, of a wheel without a drive
constexpr double kNoTrail = 0.05;               // of a radius: what turns about its own centre only is no caster
constexpr double kFlat = 0.9, kLevelAxle = 0.1; // z of unit vectors

/// The largest cylinder of the body; nullptr if another shape may be what it rolls on.
const GeomSpec* largestCylinder(const BodySpec& body) {
    const GeomSpec* largest = nullptr;
    for (const GeomSpec& geom : body.geoms) {
        if (!geom.collide) continue;
        if (geom.shape != GeomShape::Cylinder) return nullptr;
        if (!largest || geom.radius > largest->radius) largest = &geom;
    }
    return largest;
}

/// A tyre across its axle, where the axle is what is meant.
void reportTyre(DriveReport& report, const JointSpec& joint, const BodySpec& body, const GeomSpec& geom, const Vec3& axis) {
    const Vec3 along = body.pose.rotation.conjugate() * axis; // of the body's frame
    const bool isFlat = std::abs((body.pose.rotation * (geom.pose.rotation * Vec3::UnitZ())).z()) > kFlat;
    const char* turn = std::abs(along.y()) > 1 - kAlong ? "0,0,90" : std::abs(along.x()) > 1 - kAlong ? "0,90,0" : nullptr;
    Diagnostic& d = report.warn(
        geom.nameRange, geom.name + " of " + body.name + (isFlat ? " lies flat, across its axle " : " lies across its axle ") +
                            joint.name + ": the wheel does not roll; a Cylinder is along z, and HPR turns it" +
                            (turn ? std::string(": HPR=") + turn : std::string()));
    if (!turn || body.name.find('.') != std::string::npos) return;
    const auto edits = editsForValues(
        report.loaded,
        {{DottedPath("RobotConfig." + report.config.name + "." + body.name + "." + geom.name + ".HPR"), ParsedValue(turn)}});
    if (edits.ok() && edits.value().size() == 1) d.fixes.push_back({std::string("HPR=") + turn, edits.value().begin()->second});
}

/// A Suspension that springs along the axis of its wheel and rolls about the other one.
void reportExchanged(DriveReport& report, const JointSpec& joint, const BodySpec& body) {
    Diagnostic& d =
        report.warn(joint.nameRange, "Axis and Axis2 of " + joint.name + " are exchanged: along Axis it springs, about Axis2 " +
                                         body.name + " rolls");
    if (joint.name.find('.') != std::string::npos) return;
    const std::string path = "RobotConfig." + report.config.name + "." + joint.name;
    const auto edits = editsForValues(report.loaded, {{DottedPath(path + ".Axis"), ParsedValue(axisText(joint.axis2))},
                                                      {DottedPath(path + ".Axis2"), ParsedValue(axisText(joint.axis))}});
    if (edits.ok() && edits.value().size() == 1) d.fixes.push_back({"exchange them", edits.value().begin()->second});
}

/// Whether a drive has a motor for the joint, of which checkAxle() is.
bool isOfDrive(const RobotConfigSpec& config, const JointSpec& joint) {
    const auto turnsIt = [&](const DriveMotor& motor) {
        const auto device = std::ranges::find(config.devices, motor.name, &ComponentSpec::name);
        return device != config.devices.end() && device->text("Joint") == joint.name;
    };
    return std::ranges::any_of(config.devices,
                               [&](const ComponentSpec& drive) { return std::ranges::any_of(motorsOf(drive), turnsIt); });
}

/// Whether the axle points to that of another wheel of the drive, as those of both sides do.
bool isTowardsOther(const DriveReport& report, const DriveMotor& motor, const JointSpec& joint, const Vec3& axis) {
    const std::vector<DriveMotor> motors = motorsOf(report.drive);
    return std::ranges::any_of(motors, [&](const DriveMotor& other) {
        const auto device = std::ranges::find(report.config.devices, other.name, &ComponentSpec::name);
        if (other.name == motor.name || device == report.config.devices.end()) return false;
        const auto its = std::ranges::find(report.config.joints, device->text("Joint"), &JointSpec::name);
        if (its == report.config.joints.end()) return false;
        const Vec3 way = its->anchor - joint.anchor;
        return way.norm() > 0 && way.cross(axis).norm() < kAcross * way.norm() * axis.norm() &&
               std::abs(way.z()) < kAcross * way.norm();
    });
}

} // namespace

std::vector<DriveWheel> wheelsAcross(const RobotConfigSpec& config) {
    std::vector<DriveWheel> wheels;
    for (const JointSpec& joint : config.joints) {
        if (joint.type != JointType::Hinge || joint.child == 0 || joint.parent == kWorldBody || isGeared(config, joint)) continue;
        const auto child = static_cast<std::size_t>(joint.child);
        const BodySpec& body = config.bodies[child];
        const GeomSpec* geom = largestCylinder(body);
        if (!geom || geom->length > geom->radius || isOfDrive(config, joint)) continue;
        const Pose pose = body.pose * geom->pose;
        const Vec3 along = pose.rotation * Vec3::UnitZ();
        const auto actsOnIt = [&](const ComponentSpec& d) { return d.text("Joint") == joint.name; };
        const auto spinsIt = [&](const ComponentSpec& d) { return d.kind == "RotaryMotor" && actsOnIt(d); };
        const double trail = (pose.position - joint.anchor).norm();
        const bool isSwivel = std::abs(joint.axis.z()) >= kLevelAxle && std::ranges::none_of(config.devices, spinsIt) &&
                              (trail > kNoTrail * geom->radius || std::ranges::any_of(config.devices, actsOnIt));
        if (std::abs(along.z()) < kLevelAxle && !isSwivel && along.cross(joint.axis).norm() > kAcross && trail < geom->radius / 2)
            wheels.push_back({geom, nullptr, child, pose.position, joint.axis});
    }
    return wheels;
}

void checkAxle(DriveReport& report, const DriveMotor& motor) {
    const RobotConfigSpec& config = report.config;
    const auto device = std::ranges::find(config.devices, motor.name, &ComponentSpec::name);
    if (device == config.devices.end()) return;
    const auto joint = std::ranges::find(config.joints, device->text("Joint"), &JointSpec::name);
    if (joint == config.joints.end() || (joint->type != JointType::Hinge && joint->type != JointType::Suspension)) return;
    if (joint->child == 0 || isGeared(config, *joint)) return; // the chassis
    const BodySpec& body = config.bodies[static_cast<std::size_t>(joint->child)];
    const GeomSpec* geom = largestCylinder(body);
    if (!geom) return;
    const bool isSprung = joint->type == JointType::Suspension;
    const Vec3 axis = isSprung ? joint->axis2 : joint->axis, along = body.pose.rotation * (geom->pose.rotation * Vec3::UnitZ());
    if (along.cross(axis).norm() <= kAlong) return;
    if (std::abs(along.z()) > kFlat && std::abs(axis.z()) < kLevelAxle) return reportTyre(report, *joint, body, *geom, axis);
    if (isTowardsOther(report, motor, *joint, axis)) return reportTyre(report, *joint, body, *geom, axis);
    const Vec3 rolling = along.y() < -0.5 || (std::abs(along.y()) <= 0.5 && along.sum() < 0) ? Vec3(-along) : along;
    if (isSprung && rolling.cross(joint->axis).norm() <= kAlong) return reportExchanged(report, *joint, body);
    const std::string text = std::string(isSprung ? "Axis2=" : "Axis=") + axisText(rolling);
    Diagnostic& d = report.warn(joint->nameRange, joint->name + ", which " + motor.name + " of " + report.drive.name +
                                                      " turns, is not along the axis of " + body.name + "'s " + geom->name +
                                                      ": the wheel does not roll; its axis is that of " + text);
    report.addAxisFix(d, text, {&*joint}, {rolling});
}

} // namespace trundle
