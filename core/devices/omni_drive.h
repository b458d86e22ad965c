#pragma once
#include <array>

#include <trundle/drive_signals.h>

#include "devices/omni_kinematics.h"
#include "devices/wheeled_drive.h"

namespace trundle {

/// A base that moves in any direction of the floor. Its wheels grip in one direction alone: Friction2 = 0 of their Surface.
class HolonomicDrive : public WheeledDrive, public OmniDriveSignals {
public:
    void act(Actuation& world) override;
    void sense(Sensing& world) override;

protected:
    /// Binds the motors of the wheels, in their order. Fails if the wheels leave a motion open.
    void mountBase(Mount& mount, const std::vector<std::string>& motors, std::vector<FreeRollingWheel> wheels);
    template <class T> static void describeBase(Describe<T>& d) {
        describeControl(d);
        describeTurning(d);
        OmniDriveSignals::describe(d);
    }

private:
    [[nodiscard]] std::optional<PlanePose> truePose(const Services& world);
    void publishSlip(const ChassisMotion& rolled, const ChassisMotion& moved, double tick);

    OmniKinematics m_kinematics;
    std::vector<double> m_rates, m_turned;        ///< of the wheels, rad/s and rad
    std::vector<std::array<double, 2>> m_middles; ///< of the wheels in the world, m
    PlanePose m_odometryPose;
    std::optional<PlanePose> m_lastPose;
};

/// Three or more omni wheels around a middle.
class OmniDrive final : public HolonomicDrive {
public:
    static void describe(Describe<OmniDrive>& d);
    void setup(Mount& mount) override;

private:
    std::vector<std::string> m_motors;
    std::vector<double> m_anglesRad; ///< empty: even
    double m_distanceM = 0;
};

/// Four mecanum wheels, whose rollers on the floor point to the middle of the base, as a diagonal cross.
class MecanumDrive final : public HolonomicDrive {
public:
    static void describe(Describe<MecanumDrive>& d);
    void setup(Mount& mount) override;

private:
    std::string m_frontLeft, m_frontRight, m_backLeft, m_backRight;
    double m_wheelBaseM = 0, m_separationM = 0;
};

} // namespace trundle
