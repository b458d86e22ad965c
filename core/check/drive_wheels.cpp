#include "check/drive_wheels.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "check/extent.h"

namespace trundle {

namespace {

constexpr double kSameAxis = 0.02; // sine of the angle between a wheel's axis and its axle
constexpr double kBeyond = 0.05;   // of the radius
constexpr double kTouching = 0.1;  // of the radius, between a wheel and the ball that it rolls on
constexpr double kRollsOn = 0.1;   // cosine, between its axle and the way to the ball
constexpr double kLevel = 0.1;     // z of the unit axle of a free wheel

/// m, how far a geom reaches from an axle, in eight directions.
double reachOf(const GeomSpec& geom, const Pose& pose, const Vec3& anchor, const Vec3& axle) {
    const Vec3 side = axle.unitOrthogonal(), other = axle.cross(side);
    double reach = 0;
    for (int k = 0; k < 8; ++k) {
        const Vec3 out = std::cos(k * std::numbers::pi / 4) * side + std::sin(k * std::numbers::pi / 4) * other;
        reach = std::max(reach, extentAlong(geom, pose, out).high - anchor.dot(out));
    }
    return reach;
}

/// Of the joint's body, as wheelOf(); nothing if another shape, like a spoke, reaches farther from the axle.
std::optional<DriveWheel> wheelAt(const RobotConfigSpec& config, const JointSpec& joint, const ComponentSpec* motor) {
    const bool isTurnedAround = joint.child == 0 && joint.parent != kWorldBody; // the chassis is the child, the wheel its parent
    const Vec3 axle = (isTurnedAround ? -1 : 1) * (joint.type == JointType::Suspension ? joint.axis2 : joint.axis);
    const auto child = static_cast<std::size_t>(isTurnedAround ? joint.parent : joint.child);
    const BodySpec& body = config.bodies[child];
    std::optional<DriveWheel> wheel;
    double reach = 0; // m, of the others from the axle
    for (const GeomSpec& g : body.geoms) {
        const Pose pose = body.pose * g.pose;
        if (g.collide) reach = std::max(reach, reachOf(g, pose, joint.anchor, axle));
        const bool round = g.shape == GeomShape::Sphere || g.shape == GeomShape::Cylinder;
        if (!g.collide || !round) continue;
        if (g.shape == GeomShape::Cylinder && (pose.rotation * Vec3::UnitZ()).cross(axle).norm() > kSameAxis) continue;
        if (!wheel || g.radius > wheel->geom->radius) wheel = DriveWheel{&g, motor, child, pose.position, axle};
    }
    const auto isTread = [&](const GeomSpec& g) { // of a wheel whose largest cylinder is a flange
        return g.collide && g.shape == GeomShape::Cylinder && g.length > 2 * wheel->geom->length &&
               g.radius > 0.5 * wheel->geom->radius;
    };
    if (wheel && wheel->geom->shape == GeomShape::Cylinder && std::ranges::any_of(body.geoms, isTread)) return std::nullopt;
    if (wheel && reach > (1 + kBeyond) * (wheel->geom->radius + (wheel->centre - joint.anchor).cross(axle).norm()))
        return std::nullopt;
    return wheel;
}

} // namespace

std::vector<DriveMotor> motorsOf(const ComponentSpec& device) {
    std::vector<DriveMotor> motors;
    const auto add = [&](const char* key, bool isRight, bool isBack) {
        if (const ResolvedValue* value = device.find(key))
            for (std::size_t i = 0; i < value->value.texts.size(); ++i)
                motors.push_back({key, value->value.texts[i], value, isRight, isBack, i});
    };
    if (device.kind == "DifferentialDrive" || device.kind == "AckermannDrive")
        add("LeftMotor", false, true), add("RightMotor", true, true);
    if (device.kind == "SkidDrive") add("LeftMotors", false, false), add("RightMotors", true, false);
    if (device.kind == "OmniDrive") add("Motors", false, false);
    if (device.kind != "MecanumDrive") return motors;
    add("FrontLeftMotor", false, false), add("FrontRightMotor", true, false);
    add("BackLeftMotor", false, true), add("BackRightMotor", true, true);
    return motors;
}

bool isGeared(const RobotConfigSpec& config, const JointSpec& joint) {
    const auto index = static_cast<int>(&joint - config.joints.data());
    return std::ranges::any_of(config.gears, [&](const GearSpec& g) { return g.joint == index || g.other == index; });
}

double DriveWheel::stallTorque() const {
    const double resistance = motor->number("Resistance");
    if (!(resistance > 0)) return 0;
    return motor->number("TorqueConstant") * motor->number("MaxVoltage") / resistance * motor->number("GearRatio") *
           motor->number("Efficiency");
}

double DriveWheel::topRate() const {
    const double perVolt =
        motor->find("SpeedConstant") ? motor->number("SpeedConstant") : 1 / std::max(1e-9, motor->number("BackEmfConstant"));
    return motor->number("MaxVoltage") * perVolt / std::max(1e-9, motor->number("GearRatio"));
}

std::optional<DriveWheel> wheelOf(const RobotConfigSpec& config, const std::string& motor) {
    const auto device = std::ranges::find(config.devices, motor, &ComponentSpec::name);
    if (device == config.devices.end()) return std::nullopt;
    const auto joint = std::ranges::find(config.joints, device->text("Joint"), &JointSpec::name);
    if (joint == config.joints.end()) return std::nullopt;
    return isGeared(config, *joint) ? std::nullopt : wheelAt(config, *joint, &*device);
}

std::optional<DriveWheel> wheelOn(const RobotConfigSpec& config, const JointSpec& joint) {
    if (joint.type != JointType::Hinge && joint.type != JointType::Suspension) return std::nullopt;
    return wheelAt(config, joint, nullptr);
}

std::vector<DriveWheel> drivenWheelsOf(const RobotConfigSpec& config) {
    std::vector<DriveWheel> wheels;
    for (const ComponentSpec& device : config.devices)
        for (const DriveMotor& motor : motorsOf(device))
            if (const auto wheel = wheelOf(config, motor.name)) wheels.push_back(*wheel);
    return wheels;
}

std::optional<std::size_t> ballUnder(const RobotConfigSpec& config, const DriveWheel& wheel) {
    for (std::size_t b = 0; b < config.bodies.size(); ++b)
        for (const GeomSpec& geom : config.bodies[b].geoms) {
            if (b == wheel.body || !geom.collide || geom.shape != GeomShape::Sphere) continue;
            const Vec3 way = (config.bodies[b].pose * geom.pose).position - wheel.centre;
            const double gap = way.norm() - geom.radius - wheel.geom->radius;
            if (std::abs(gap) < kTouching * wheel.geom->radius && std::abs(way.normalized().dot(wheel.axis)) < kRollsOn) return b;
        }
    return std::nullopt;
}

std::vector<DriveWheel> freeWheelsOf(const RobotConfigSpec& config) {
    std::vector<DriveWheel> wheels;
    for (const JointSpec& joint : config.joints) {
        if (isGeared(config, joint)) continue;
        const auto turnsIt = [&](const ComponentSpec& device) {
            return device.kind != "Encoder" && device.text("Joint") == joint.name;
        };
        if (std::ranges::any_of(config.devices, turnsIt)) continue;
        const auto wheel = wheelOn(config, joint);
        if (wheel && wheel->geom->shape == GeomShape::Cylinder && std::abs(wheel->axis.z()) < kLevel) wheels.push_back(*wheel);
    }
    return wheels;
}

} // namespace trundle
