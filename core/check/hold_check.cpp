// Servos and linear motors too weak for the weight of what they carry, by statics: the torque of gravity about the joint, through its range.
#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "check/body_groups.h"
#include "check/checks.h"
#include "check/drive_wheels.h"

namespace trundle {

namespace {

constexpr int kSteps = 72;
constexpr double kSameWay = 1e-6;
constexpr double kLevelled = 0.05; // of its weight: less than this along a slider's axis is no lift

/// What a joint holds apart from the rest of its robot.
struct Load {
    double mass = 0; ///< kg; 0: the joint is part of a closed loop
    Vec3 centre = Vec3::Zero();
};

/// The side of a joint that does not hang on the world; of a robot that is held nowhere the lighter one: a leg holds its foot up at
/// least, an arm its hand.
Load loadOf(const RobotConfigSpec& config, const JointSpec& joint) {
    BodyGroups groups(config.bodies.size());
    for (const JointSpec& other : config.joints)
        if (&other != &joint) groups.join(other.parent, other.child);
    for (const SpringSpec& spring : config.springs) groups.join(spring.parent, spring.child);
    const std::size_t world = groups.of(kWorldBody), parent = groups.of(joint.parent), child = groups.of(joint.child);
    if (parent == child) return {};
    const auto sum = [&](std::size_t side) {
        Load load;
        for (std::size_t i = 0; i < config.bodies.size(); ++i) {
            if (groups.of(static_cast<int>(i)) != side) continue;
            const BodySpec& body = config.bodies[i];
            load.mass += body.mass.mass;
            load.centre += body.mass.mass * (body.pose * body.mass.centre);
        }
        if (load.mass > 0) load.centre /= load.mass;
        return load;
    };
    if (parent == world) return sum(child);
    if (child == world) return sum(parent);
    const Load carried = sum(child), carrier = sum(parent);
    return carried.mass <= carrier.mass ? carried : carrier;
}

/// Reports a linear motor that cannot lift what is on its slider.
void checkLift(const RobotConfigSpec& config, const ComponentSpec& motor, const JointSpec& joint, double force,
               Diagnostics& diagnostics) {
    const double most = motor.number("MaxForce");
    if (force <= most) return;
    diagnostics.warning(Code::WeakMotor, motor.nameRange,
                        motor.name + " of " + config.name + " cannot lift what is on " + joint.name + ": that weighs " +
                            figureText(force) + " N along its axis, MaxForce is " + figureText(most) + " N");
}

/// Reports a servo that cannot hold its load in a part of its range. `gravity`: m/s², in the frame of the config.
void checkArm(const RobotConfigSpec& config, const ComponentSpec& servo, const JointSpec& joint, const Load& load,
              const Vec3& gravity, Diagnostics& diagnostics) {
    constexpr double kHalfTurn = 180 * kDegree;
    const double low = std::max(joint.lowStop.value_or(-kHalfTurn), -kHalfTurn),
                 high = std::min(joint.highStop.value_or(kHalfTurn), kHalfTurn);
    const auto torqueAt = [&](double angle) {
        const Vec3 arm = Eigen::AngleAxisd(angle, joint.axis) * (load.centre - joint.anchor);
        return std::abs(arm.cross(load.mass * gravity).dot(joint.axis));
    };
    double worst = 0, at = 0; // N m, rad
    for (int i = 0; i <= kSteps; ++i)
        if (const double angle = low + (high - low) * i / kSteps, torque = torqueAt(angle); torque > worst)
            worst = torque, at = angle;
    const double most = servo.number("MaxTorque");
    if (worst <= most || torqueAt(0) > most) return; // the latter is tried: something else may carry it at the start
    diagnostics.hint(Code::WeakMotor, servo.nameRange,
                     servo.name + " of " + config.name + " cannot hold " + joint.name + " everywhere: at " +
                         figureText(at / kDegree) + " degrees what hangs on it takes " + figureText(worst) +
                         " N m, MaxTorque is " + figureText(most) + " N m");
}

void checkHold(const RobotConfigSpec& config, const ComponentSpec& motor, const Vec3& gravity, Diagnostics& diagnostics) {
    const auto joint = std::ranges::find(config.joints, motor.text("Joint"), &JointSpec::name);
    if (joint == config.joints.end() || joint->stiffness > 0 || isGeared(config, *joint)) return;
    const Load load = loadOf(config, *joint);
    if (!(load.mass > 0)) return;
    const double along = std::abs(joint->axis.dot(gravity));
    if (motor.kind == "LinearMotor" && joint->type == JointType::Slider && along > kLevelled * gravity.norm())
        checkLift(config, motor, *joint, load.mass * along, diagnostics);
    if (motor.kind == "Servo" && motor.text("Mode") != "speed" && joint->type == JointType::Hinge)
        checkArm(config, motor, *joint, load, gravity, diagnostics);
}

} // namespace

void checkHolds(const ExperimentSpec& experiment, Diagnostics& diagnostics) {
    std::map<const RobotConfigSpec*, std::vector<Vec3>> seen; // by config: the ways it hangs; its order, by address, is not used
    for (const RobotSpec& robot : experiment.robots) {
        const Vec3 gravity = robot.pose.rotation.conjugate() * experiment.settings.gravity;
        std::vector<Vec3>& ways = seen[robot.config.get()];
        if (std::ranges::any_of(ways, [&](const Vec3& way) { return (way - gravity).norm() < kSameWay * gravity.norm(); }))
            continue;
        ways.push_back(gravity);
        for (const ComponentSpec& motor : robot.config->devices)
            if (motor.kind == "Servo" || motor.kind == "LinearMotor") checkHold(*robot.config, motor, gravity, diagnostics);
    }
}

} // namespace trundle
