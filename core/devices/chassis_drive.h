#pragma once
#include <optional>
#include <span>

#include "devices/wheeled_drive.h"

namespace trundle {

/// A base with driven wheels on both sides, on parallel axles: chassis motion and wheel speeds by thesis eqs. 3.2-3.7. Odometry uses
/// only the joint angles, of each side on average.
class SidedDrive : public WheeledDrive {
protected:
    template <class T> static void describeSides(Describe<T>& d) {
        describeRadius(d);
        d.field("WheelSeparation", &SidedDrive::m_separationM, metres().within(1e-4, 1e3).required(),
                "Between the wheels' middles.");
    }
    /// Binds the motors of both sides, at least one each. If one is missing, fails with a list of the available names.
    void mountSides(Mount& mount, const std::vector<std::string>& left, const std::vector<std::string>& right);
    [[nodiscard]] double separation() const { return m_separationM * m_skidFactor; }

    void driveSides(Actuation& world, const ChassisMotion& velocity);
    /// The pose from the wheels' angles, counted from the start. To be called once per tick, in sense.
    const PlanePose& odometer(const Services& world);
    /// Of the middle between the anchors of both sides, in the world, as of the last wheelSlip(); those of the left side give the direction of +y.
    [[nodiscard]] std::optional<PlanePose> truePose();

    /// m/s by which the wheels of each side roll faster than their axles move, on average. To be called once per tick, in sense.
    [[nodiscard]] WheelMotion wheelSlip(const Services& world);

    double m_skidFactor = 1;

private:
    [[nodiscard]] std::span<Wheel> left() { return std::span(wheels()).first(m_leftCount); }
    [[nodiscard]] std::span<Wheel> right() { return std::span(wheels()).subspan(m_leftCount); }

    double m_separationM = 0;
    std::size_t m_leftCount = 0;
    PlanePose m_odometryPose;
};

/// Converts a speed and a turn rate into wheel speeds and commands the motors.
class ChassisDrive : public SidedDrive, public DifferentialDriveSignals {
public:
    void act(Actuation& world) override;
    void sense(Sensing& world) override;

protected:
    /// Describes all but the motors.
    template <class T> static void describeDrive(Describe<T>& d) {
        describeSides(d);
        describeControl(d);
        describeTurning(d);
    }
};

} // namespace trundle
