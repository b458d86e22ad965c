#include "devices/ackermann_drive.h"

#include <algorithm>
#include <cmath>

namespace trundle {

void AckermannDrive::describe(Describe<AckermannDrive>& d) {
    d.help("A base with two driven wheels at the back and two steered wheels in front, as a car.").independent();
    d.field("LeftMotor", &AckermannDrive::m_leftMotor, reference("RotaryMotor").required(),
            "Turns the left back wheel; forward is positive.");
    d.field("RightMotor", &AckermannDrive::m_rightMotor, reference("RotaryMotor").required(), "Turns the right back wheel.");
    d.field("LeftSteering", &AckermannDrive::m_leftSteering, reference("Servo").required(),
            "Steers the left front wheel, which points ahead in the start pose; a positive angle turns it left.");
    d.field("RightSteering", &AckermannDrive::m_rightSteering, reference("Servo").required(), "Steers the right front wheel.");
    describeSides(d);
    d.field("WheelBase", &AckermannDrive::m_wheelBaseM, metres().within(1e-4, 1e3).required(),
            "Between the driven axle and the middles of the steered wheels.");
    d.field("SteeringSeparation", &AckermannDrive::m_steeringSeparationM, metres().within(0, 1e3),
            "Between the axes about which the front wheels are steered; 0: as WheelSeparation.");
    d.field("MaxSteeringAngle", &AckermannDrive::m_maxSteeringRad, degrees().within(1, 80),
            "Of a wheel midway between the steered ones, to each side.");
    describeControl(d);
    AckermannDriveSignals::describe(d);
}

void AckermannDrive::setup(Mount& mount) {
    const double half = (m_steeringSeparationM > 0 ? m_steeringSeparationM : separation()) / 2;
    if (m_leftSteering == m_rightSteering) return mount.fail("LeftSteering and RightSteering are the same servo");
    if (std::tan(m_maxSteeringRad) * half >= m_wheelBaseM)
        return mount.fail("at MaxSteeringAngle the centre of the turn would lie between the wheels; make it smaller");
    mountSides(mount, {m_leftMotor}, {m_rightMotor});
    m_left = mountSteered(mount, m_leftSteering, half);
    m_right = mountSteered(mount, m_rightSteering, -half);
}

AckermannDrive::Steered AckermannDrive::mountSteered(Mount& mount, const std::string& servo, double y) const {
    Steered wheel;
    wheel.y = y;
    wheel.servo = mount.peer<ServoSignals>(servo);
    if (!wheel.servo.bound()) return wheel;
    if (mount.peerText(servo, "Mode") == "speed")
        mount.fail("the servo " + servo + " steers a wheel and must have Mode=position");
    wheel.joint = mount.joint(mount.peerText(servo, "Joint"));
    return wheel;
}

/// Of a wheel at y that is steered by a: tan a = k L / (1 - k y), with k the curvature of the driven axle's middle and L the wheel base.
double AckermannDrive::curvature(const Services& world) const {
    double sum = 0;
    for (const Steered* wheel : {&m_left, &m_right}) {
        const double slope = std::tan(world.jointPosition(wheel->joint));
        sum += slope / (m_wheelBaseM + slope * wheel->y);
    }
    return sum / 2;
}

/// The back wheels turn as the front wheels point now, as with a differential.
void AckermannDrive::act(Actuation& world) {
    const double asked = steeringAngle.read(world), angle = std::clamp(asked, -m_maxSteeringRad, m_maxSteeringRad);
    if (angle != asked && !m_reportedSteering) {
        m_reportedSteering = true;
        world.warn("steeringAngle is beyond MaxSteeringAngle, which holds");
    }
    const double slope = std::tan(angle);
    for (Steered* wheel : {&m_left, &m_right})
        wheel->servo.set(&ServoSignals::target, std::atan2(slope, 1 - slope * wheel->y / m_wheelBaseM));
    ChassisMotion velocity =
        follow(world, {linearVelocity.read(world), 0, 0}, {linearAmount.read(world), 0, 0}, sequence.read(world));
    velocity.angular = velocity.linear * curvature(world);
    driveSides(world, velocity);
}

void AckermannDrive::sense(Sensing& world) {
    AckermannDriveSignals& signals = *this;
    steering.set(std::atan(curvature(world) * m_wheelBaseM));
    publishState(signals, odometer(world));
    const WheelMotion slips = wheelSlip(world);
    publishPose(signals, truePose());
    slip.set(0, slips.left);
    slip.set(1, slips.right);
}

} // namespace trundle
