#include "devices/omni_drive.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace trundle {
namespace {

constexpr double kPi = std::numbers::pi;

} // namespace

void HolonomicDrive::mountBase(Mount& mount, const std::vector<std::string>& motors, std::vector<FreeRollingWheel> wheels) {
    m_kinematics = OmniKinematics(radius(), std::move(wheels));
    if (!m_kinematics.isComplete())
        return mount.fail("its wheels leave a motion open: each way to move, and turning, needs wheels that grip along it");
    mountWheels(mount, motors);
    m_rates.resize(motors.size());
    m_turned.resize(motors.size());
    m_middles.resize(motors.size());
}

void HolonomicDrive::act(Actuation& world) {
    const ChassisMotion velocity{linearVelocity.read(world), angularVelocity.read(world), lateralVelocity.read(world)};
    const double speed = std::hypot(velocity.linear, velocity.lateral), way = linearAmount.read(world);
    ChassisMotion amount{way, angularAmount.read(world), 0};
    if (speed > 0) {
        amount.linear = way * (velocity.linear / speed);
        amount.lateral = way * (velocity.lateral / speed);
    }
    const ChassisMotion now = follow(world, velocity, amount, sequence.read(world));
    double fastest = 0;
    for (std::size_t i = 0; i < m_rates.size(); ++i) {
        m_rates[i] = m_kinematics.wheelFromChassis(i, now);
        fastest = std::max(fastest, std::abs(m_rates[i]));
    }
    warnOfSpeeds(world, now.angular, fastest);
    for (std::size_t i = 0; i < m_rates.size(); ++i) drive(world, wheels()[i], m_rates[i]);
}

void HolonomicDrive::sense(Sensing& world) {
    for (std::size_t i = 0; i < m_turned.size(); ++i) m_turned[i] = wheels()[i].turnedSince(world);
    const ChassisMotion rolled = m_kinematics.chassisFromWheels(m_turned);
    m_odometryPose = alongArc(m_odometryPose, rolled);
    OmniDriveSignals& signals = *this;
    publishState(signals, m_odometryPose);
    const std::optional<PlanePose> now = truePose(world);
    publishPose(signals, now);
    if (now && m_lastPose) publishSlip(rolled, motionBetween(*m_lastPose, *now), world.tick());
    m_lastPose = now;
}

/// Of a tick, m and rad.
void HolonomicDrive::publishSlip(const ChassisMotion& rolled, const ChassisMotion& moved, double tick) {
    slip.set(0, (rolled.linear - moved.linear) / tick);
    slip.set(1, (rolled.lateral - moved.lateral) / tick);
    slip.set(2, (rolled.angular - moved.angular) / tick);
}

std::optional<PlanePose> HolonomicDrive::truePose(const Services& world) {
    Vec3 anchor, axis;
    for (std::size_t i = 0; i < m_middles.size(); ++i) {
        if (!world.jointAnchor(wheels()[i].joint, anchor, axis)) return std::nullopt;
        m_middles[i] = {anchor.x(), anchor.y()};
    }
    return m_kinematics.poseFrom(m_middles);
}

void OmniDrive::describe(Describe<OmniDrive>& d) {
    d.help("A base with three or more omni wheels around its middle, which moves in any direction.").independent();
    d.field("Motors", &OmniDrive::m_motors, reference("RotaryMotor").required().counted(3, 100),
            "Turn the wheels; a positive rate of all of them turns the base to the left.");
    describeRadius(d);
    d.field("WheelDistance", &OmniDrive::m_distanceM, metres().within(1e-4, 1e3).required(),
            "From the middle of the base to those of the wheels.");
    d.field(
        "WheelAngles", &OmniDrive::m_anglesRad, degrees().within(-1e4, 1e4).counted(0, 100),
        "Where each wheel is, from the front to the left. Without it the wheels are at even steps, the first by half of one.");
    describeBase(d);
}

/// A wheel rolls across the line from the middle to it.
void OmniDrive::setup(Mount& mount) {
    const std::size_t count = m_motors.size();
    if (!m_anglesRad.empty() && m_anglesRad.size() != count)
        return mount.fail(std::to_string(count) + " Motors need as many WheelAngles, not " + std::to_string(m_anglesRad.size()));
    std::vector<FreeRollingWheel> wheels;
    for (std::size_t i = 0; i < count; ++i) {
        const double even = kPi * static_cast<double>(2 * i + 1) / static_cast<double>(count);
        const double angle = m_anglesRad.empty() ? even : m_anglesRad[i], c = std::cos(angle), s = std::sin(angle);
        wheels.push_back({m_distanceM * c, m_distanceM * s, -s, c, 1});
    }
    mountBase(mount, m_motors, std::move(wheels));
}

void MecanumDrive::describe(Describe<MecanumDrive>& d) {
    d.help("A base with four mecanum wheels, which moves in any direction.").independent();
    const auto motor = reference("RotaryMotor").required();
    d.field("FrontLeftMotor", &MecanumDrive::m_frontLeft, motor, "Turns that wheel; forward is positive.");
    d.field("FrontRightMotor", &MecanumDrive::m_frontRight, motor, "Turns that wheel.");
    d.field("BackLeftMotor", &MecanumDrive::m_backLeft, motor, "Turns that wheel.");
    d.field("BackRightMotor", &MecanumDrive::m_backRight, motor, "Turns that wheel.");
    describeRadius(d);
    d.field("WheelBase", &MecanumDrive::m_wheelBaseM, metres().within(1e-4, 1e3).required(), "Between the axles.");
    d.field("WheelSeparation", &MecanumDrive::m_separationM, metres().within(1e-4, 1e3).required(),
            "Between the wheels' middles, left to right.");
    describeBase(d);
}

/// Rollers at 45 degrees: on the floor their axles, along which they grip, lie across the lines to the middle of a square base.
void MecanumDrive::setup(Mount& mount) {
    const double x = m_wheelBaseM / 2, y = m_separationM / 2, c = std::sqrt(0.5);
    mountBase(mount, {m_frontLeft, m_frontRight, m_backLeft, m_backRight},
              {{x, y, c, -c, c}, {x, -y, c, c, c}, {-x, y, c, c, c}, {-x, -y, c, -c, c}});
}

} // namespace trundle
