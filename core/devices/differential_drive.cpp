#include "devices/differential_drive.h"

namespace trundle {

void DifferentialDrive::describe(Describe<DifferentialDrive>& d) {
    d.help("A base with two driven wheels: turns speeds of the robot into speeds of the wheels.").independent();
    d.field("LeftMotor", &DifferentialDrive::m_leftMotor, reference("RotaryMotor").required(),
            "Turns the left wheel; forward is positive.");
    d.field("RightMotor", &DifferentialDrive::m_rightMotor, reference("RotaryMotor").required(), "Turns the right wheel.");
    describeDrive(d);
    DifferentialDriveSignals::describe(d);
}

void DifferentialDrive::setup(Mount& mount) {
    if (m_leftMotor == m_rightMotor) return mount.fail("LeftMotor and RightMotor are the same motor");
    mountSides(mount, {m_leftMotor}, {m_rightMotor});
}

void SkidDrive::describe(Describe<SkidDrive>& d) {
    d.help("A base with several driven wheels on each side, which turns by driving one side faster.").independent();
    d.field("LeftMotors", &SkidDrive::m_leftMotors, reference("RotaryMotor").required().counted(1, 100),
            "Turn the wheels of the left side; forward is positive.");
    d.field("RightMotors", &SkidDrive::m_rightMotors, reference("RotaryMotor").required().counted(1, 100),
            "Turn the wheels of the right side.");
    describeDrive(d);
    d.field("SkidFactor", &SkidDrive::m_skidFactor, number().within(1, 100),
            "Multiplies WheelSeparation: wheels that skid sideways have to be this much faster for a turn.");
    DifferentialDriveSignals::describe(d);
}

void SkidDrive::setup(Mount& mount) { mountSides(mount, m_leftMotors, m_rightMotors); }

} // namespace trundle
