// Tries a drive. Method: a slow speed, half of that without load at most, is commanded for two seconds; the motion of the second one of
// them is compared with it. Directions count from each other, as the frame of a robot may point anywhere.
#include "check/trial_drive.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "check/checks.h"
#include "check/drive_wheels.h"
#include "check/extent.h"

namespace trundle {

namespace {

constexpr double kRamp = 1, kMeasure = 1, kPause = 0.7; // s
constexpr double kTopShare = 0.5;                       // of the speed without load
constexpr double kLeast = 0.5, kMost = 1.5;             // of the commanded motion
constexpr double kLeastSkids = 0.2;                     // of a turn, where wheels skid
constexpr double kSlowest = 2e-3;                       // m/s; slower ones are lost in the noise of contacts
constexpr double kFastestTurn = 2;                      // rad/s
constexpr double kStraight = 20 * kDegree;              // by which one that drives straight may turn
constexpr double kSideways = 30 * kDegree;
constexpr double kSlips = 0.3;                  // of the speed
constexpr double kStill = 0.02;                 // of the speed
constexpr double kTurns = 0.1, kDragged = 0.05; // of the speed, of the weight
constexpr double kSlickTyre = 0.1;              // coefficient of friction
constexpr double kAtStop = 2 * kDegree;
constexpr double kLeastGrip = 0.03;             // of the weight: what slips with less drags nothing

struct Moved {
    Vec3 way = Vec3::Zero(); ///< m, as seen from the heading at its start
    double turn = 0;         ///< rad, to the left
    std::string slipping;    ///< what a wheel does that does not roll with the robot; empty: all roll
    SourceRange slippingAt;
};

/// rad, about z, from that at the start pose.
double headingOf(const Quat& rotation) {
    const Mat3 turn = rotation.toRotationMatrix();
    return std::atan2(turn(1, 0) - turn(0, 1), turn(0, 0) + turn(1, 1));
}

class DriveTrial {
public:
    DriveTrial(TrialWorld& world, const RobotConfigSpec& config, const ComponentSpec& drive, Diagnostics& diagnostics,
               const std::stop_token& stop)
        : m_world(world), m_config(config), m_drive(drive), m_diagnostics(diagnostics), m_stop(stop) {
        for (const BodySpec& body : config.bodies) m_weight += body.mass.mass * world.gravity();
    }

    bool run() {
        m_speed = speed();
        if (m_speed < kSlowest) return true;
        const bool isCar = m_drive.kind == "AckermannDrive",
                   isOmni = m_drive.kind == "OmniDrive" || m_drive.kind == "MecanumDrive";
        const auto ahead = measure("linearVelocity", m_speed);
        if (!ahead || !isAhead(*ahead)) return ahead.has_value();
        if (!ahead->slipping.empty() && !isLoose()) return reportSlip(*ahead), true;
        const auto turned = isCar ? steer() : turn();
        if (!turned || !*turned || !isOmni) return turned.has_value();
        const auto aside = measure("lateralVelocity", m_speed);
        if (aside) checkAside(*ahead, *aside);
        return aside.has_value();
    }

private:
    [[nodiscard]] const ComponentSpec* device(const std::string& name) const {
        const auto found = std::ranges::find(m_config.devices, name, &ComponentSpec::name);
        return found == m_config.devices.end() ? nullptr : &*found;
    }

    /// m/s, that it reaches and keeps: by its motors, its ramps and its size.
    [[nodiscard]] double speed() const {
        double top = HUGE_VAL, ramp = m_drive.number("MaxAcceleration"); // m/s, m/s^2
        for (const DriveMotor& motor : motorsOf(m_drive)) {
            DriveWheel wheel;
            wheel.motor = device(motor.name);
            if (wheel.motor) top = std::min(top, wheel.topRate() * m_drive.number("WheelRadius"));
        }
        for (const char* key : {"LeftTrack", "RightTrack"})
            if (const ComponentSpec* track = device(m_drive.text(key))) {
                top = std::min(top, track->number("MaxSpeed"));
                if (const double own = track->number("MaxAcceleration"); own > 0) ramp = ramp > 0 ? std::min(ramp, own) : own;
            }
        double size = 0; // m
        for (const BodySpec& body : m_config.bodies)
            for (const GeomSpec& geom : body.geoms)
                if (geom.collide) size = std::max(size, geom.pose.position.norm() + body.pose.position.norm());
        return std::min({kTopShare * top, std::max(size, 0.05) / kMeasure, ramp > 0 ? 0.5 * ramp * kRamp : HUGE_VAL});
    }

    /// Nothing if the world ended.
    [[nodiscard]] std::optional<Moved> measure(const char* signal, double value) {
        m_world.command(m_drive.name, signal, value);
        if (!m_world.run(kRamp, m_stop)) return std::nullopt;
        const Pose from = m_world.pose();
        if (!m_world.run(kMeasure, m_stop)) return std::nullopt;
        const Pose to = m_world.pose();
        m_causes = causes();
        const double heading = headingOf(from.rotation);
        const Vec3 way = Eigen::AngleAxisd(-heading, Vec3::UnitZ()) * (to.position - from.position);
        Moved moved{{way.x(), way.y(), 0}, headingOf(to.rotation * from.rotation.conjugate()), {}, {}};
        for (const JointSpec& joint : m_config.joints)
            if (moved.slipping.empty()) findSlip(joint, moved);
        m_world.command(m_drive.name, signal, 0);
        if (!m_world.run(kPause, m_stop)) return std::nullopt;
        return moved;
    }

    /// By a motor that no drive has: a brush, a tool.
    [[nodiscard]] bool isTurnedByOther(const JointSpec& joint) const {
        return std::ranges::any_of(m_config.devices, [&](const ComponentSpec& device) {
            const bool turns = device.kind == "RotaryMotor" || device.kind == "Servo";
            const std::vector<DriveMotor> own = motorsOf(m_drive);
            return turns && device.text("Joint") == joint.name &&
                   std::ranges::find(own, device.name, &DriveMotor::name) == own.end();
        });
    }

    /// Whether the wheel on a joint rolls as fast as the robot moves along with it, at the end of a way.
    void findSlip(const JointSpec& joint, Moved& moved) const {
        const auto wheel = wheelOn(m_config, joint);
        if (!wheel || std::abs(wheel->axis.z()) > 0.5) return;
        const BodySpec& body = m_config.bodies[wheel->body];
        const Pose now = m_world.bodyPose(body);
        const double grip = m_world.surface(*wheel->geom).friction;
        if (m_world.loadOf(body) * grip < kLeastGrip * m_weight || isTurnedByOther(joint)) return;
        const Vec3 along = (now.rotation * (body.pose.rotation.conjugate() * wheel->axis)).cross(Vec3::UnitZ());
        const double rolls = std::abs(m_world.value(joint.name + "/rate")) * wheel->geom->radius,
                     moves = std::abs(m_world.velocity(body).dot(along.normalized()));
        if (std::abs(rolls - moves) <= kSlips * m_speed) return;
        moved.slipping = body.name + " rolls at " + lengthText(rolls) + "/s where it moves at " + lengthText(moves) + "/s";
        moved.slippingAt = joint.nameRange;
    }

    [[nodiscard]] bool isLoose() const { return m_drive.text("Control") == "voltage"; }

    bool isAhead(const Moved& moved) {
        const double share = moved.way.norm() / (m_speed * kMeasure);
        if (std::abs(moved.turn) > kStraight)
            return report("turns the robot " + sideOf(moved.turn) + " instead of driving it straight ahead");
        if (share < (isLoose() ? 0 : kLeast) || share > kMost)
            return report(movesText(moved) + " when commanded to drive at " + lengthText(m_speed) + "/s");
        return true;
    }

    /// On the spot. Nothing if the world ended.
    [[nodiscard]] std::optional<bool> turn() {
        double radius = m_drive.number("WheelSeparation") / 2; // m
        if (m_drive.kind == "OmniDrive") radius = m_drive.number("WheelDistance");
        if (m_drive.kind == "MecanumDrive") radius += m_drive.number("WheelBase") / 2;
        if (m_drive.kind == "TrackDrive") radius = m_drive.number("TrackSeparation") / 2;
        const double ramp = m_drive.number("MaxAngularAcceleration");
        double rate = std::min(m_speed / (radius * std::max(1.0, m_drive.number("SkidFactor", 1))), kFastestTurn);
        if (ramp > 0) rate = std::min(rate, 0.5 * ramp * kRamp);
        const auto moved = measure("angularVelocity", rate);
        if (!moved) return std::nullopt;
        const auto isServo = [](const ComponentSpec& device) {
            return device.kind == "Servo";
        }; // it may hold a wheel that steers
        const bool skids = m_drive.kind == "SkidDrive" || m_drive.kind == "TrackDrive" || !m_config.gears.empty();
        const double least = isLoose() || std::ranges::any_of(m_config.devices, isServo) ? 0 : skids ? kLeastSkids : kLeast;
        return isTurned(moved->turn, rate * kMeasure, least);
    }

    [[nodiscard]] std::optional<bool> steer() {
        const double angle = 0.6 * m_drive.number("MaxSteeringAngle");
        m_world.command(m_drive.name, "steeringAngle", angle);
        const auto moved = measure("linearVelocity", m_speed);
        if (!moved) return std::nullopt;
        return isTurned(moved->turn, m_speed * std::tan(angle) / m_drive.number("WheelBase") * kMeasure, isLoose() ? 0 : kLeast);
    }

    bool isTurned(double is, double wanted, double least) {
        const double share = is / wanted;
        if (share < -0.1) return report("turns the robot to the right when commanded to turn it to the left");
        if ((least == 0 || share >= least) && share <= kMost) return true;
        if (share <= kMost && isAtStop()) return true; // what it draws cannot follow on the spot
        const double round = std::round(is / kDegree * 10) / 10 + 0.;
        return report("turns the robot by " + figureText(round) + " degrees in a second when commanded to turn it by " +
                      figureText(wanted / kDegree));
    }

    void checkAside(const Moved& ahead, const Moved& aside) {
        const double share = aside.way.norm() / (m_speed * kMeasure);
        const Vec3 left = Vec3::UnitZ().cross(ahead.way).normalized();
        if (share > kLeast && share < kMost && aside.way.dot(left) > std::cos(kSideways) * aside.way.norm() &&
            std::abs(aside.turn) < kStraight)
            return;
        const double angle = std::atan2(ahead.way.cross(aside.way).z(), ahead.way.dot(aside.way)) / kDegree;
        report(share <= kLeast ? movesText(aside) + " when commanded to move it to the left at " + lengthText(m_speed) + "/s"
               : std::abs(aside.turn) >= kStraight
                   ? "turns the robot " + sideOf(aside.turn) + " when commanded to move it to the left"
                   : "moves the robot " + figureText(std::abs(angle)) + " degrees to the " + (angle < 0 ? "right" : "left") +
                         " of its way ahead when commanded to move it to the left");
    }

    void reportSlip(const Moved& moved) {
        m_diagnostics.warning(
            Code::MovesOtherwise, moved.slippingAt,
            "tried on a plain floor, " + moved.slipping + " when " + m_drive.name + " of " + m_config.name +
                " drives straight ahead: it is dragged or slips; check what turns or brakes it: motor, Gear, Friction, "
                "stops");
    }

    [[nodiscard]] std::string movesText(const Moved& moved) const {
        const double rate = moved.way.norm() / kMeasure;
        return rate < kStill * m_speed ? "does not move the robot" : "moves the robot at " + lengthText(rate) + "/s";
    }
    /// What is seen while it is to move: motors that do not turn, and what it drags over the floor.
    [[nodiscard]] std::string causes() const {
        for (const DriveMotor& motor : motorsOf(m_drive)) {
            const ComponentSpec* turning = device(motor.name);
            const std::string joint = turning ? turning->text("Joint") : std::string();
            const double rim = std::abs(m_world.value(joint + "/rate")) * m_drive.number("WheelRadius");
            if (rim < kTurns * m_speed)
                return ": " + motor.name + " does not turn " + joint + "; check " +
                       (turning && turning->number("CurrentLimit") > 0 ? "the CurrentLimit of the motor, " : "") +
                       "its stops, its Friction and what it is joined to";
        }
        for (const JointSpec& joint : m_config.joints)
            if (joint.type == JointType::Fixed && joint.parent == kWorldBody)
                return ": " + joint.name + " fixes " + m_config.bodies[static_cast<std::size_t>(joint.child)].name +
                       " to the world";
        if (const std::string grip = whyNoGrip(); !grip.empty()) return ": " + grip;
        for (const BodySpec& body : m_config.bodies) {
            const auto rolls = [&](const JointSpec& joint) {
                const auto wheel = wheelOn(m_config, joint);
                return wheel && &m_config.bodies[wheel->body] == &body;
            };
            const auto isRound = [](const GeomSpec& geom) {
                return geom.shape == GeomShape::Sphere || geom.shape == GeomShape::Cylinder;
            };
            if (std::ranges::any_of(m_config.joints, rolls) || std::ranges::any_of(body.geoms, isRound)) continue;
            if (m_world.loadOf(body) > kDragged * m_weight) return ": " + body.name + " is dragged over the floor";
        }
        return {};
    }
    /// Of a driven wheel that cannot push the robot; empty: none is like that.
    [[nodiscard]] std::string whyNoGrip() const {
        for (const DriveMotor& motor : motorsOf(m_drive)) {
            const ComponentSpec* turning = device(motor.name);
            const auto joint =
                std::ranges::find(m_config.joints, turning ? turning->text("Joint") : std::string(), &JointSpec::name);
            if (joint == m_config.joints.end() || joint->child == 0 || isGeared(m_config, *joint)) continue;
            const BodySpec& body = m_config.bodies[static_cast<std::size_t>(joint->child)];
            const auto touches = [](const GeomSpec& geom) { return geom.collide; };
            const auto grips = [&](const GeomSpec& geom) { return geom.collide && m_world.surface(geom).friction > kSlickTyre; };
            const auto isParent = [&](const JointSpec& other) { return other.parent == joint->child; }; // its rollers touch
            if (std::ranges::any_of(m_config.joints, isParent)) continue;
            if (std::ranges::none_of(body.geoms, touches)) return "nothing of " + body.name + " collides, so that it cannot push";
            if (std::ranges::none_of(body.geoms, grips))
                return "the Surface of " + body.name + " has hardly any Friction, so that it cannot push";
        }
        return {};
    }
    /// Whether a joint that no motor turns has come to its stop, as the coupling of a trailer.
    [[nodiscard]] bool isAtStop() const {
        return std::ranges::any_of(m_config.joints, [&](const JointSpec& joint) {
            const auto turnsIt = [&](const ComponentSpec& d) { return d.kind != "Encoder" && d.text("Joint") == joint.name; };
            if (joint.type != JointType::Hinge || std::ranges::any_of(m_config.devices, turnsIt)) return false;
            const double at = m_world.value(joint.name + "/position");
            return (joint.lowStop && at < *joint.lowStop + kAtStop) || (joint.highStop && at > *joint.highStop - kAtStop);
        });
    }
    static std::string sideOf(double turn) { return turn < 0 ? "to the right" : "to the left"; }

    bool report(const std::string& what) {
        m_diagnostics.warning(Code::MovesOtherwise, m_drive.nameRange,
                              "tried on a plain floor, " + m_drive.name + " of " + m_config.name + " " + what +
                                  (m_causes.empty() ? "; check what turns with its motors: axes and gears" : m_causes));
        return false;
    }

    TrialWorld& m_world;
    const RobotConfigSpec& m_config;
    const ComponentSpec& m_drive;
    Diagnostics& m_diagnostics;
    const std::stop_token& m_stop;
    double m_speed = 0;  ///< m/s, that is commanded
    double m_weight = 0; ///< N
    std::string m_causes;
};

} // namespace

bool tryDrive(TrialWorld& world, const RobotConfigSpec& config, const ComponentSpec& drive, Diagnostics& diagnostics,
              const std::stop_token& stop) {
    return DriveTrial(world, config, drive, diagnostics, stop).run();
}

bool isDrive(const ComponentSpec& device) { return !motorsOf(device).empty() || device.kind == "TrackDrive"; }

} // namespace trundle
