#pragma once
// Planar kinematics of bases whose wheels roll freely in one direction of the floor: omni wheels along their axles, mecanum wheels across
// the axles of their rollers. Source: P. F. Muir and C. P. Neuman, "Kinematic modeling of wheeled mobile robots", J. Robotic Systems
// 4(2), 1987.

#include <array>
#include <vector>

#include "devices/kinematics.h"

namespace trundle {

/// A wheel in the frame of its base: x forwards, y to the left.
struct FreeRollingWheel {
    double x = 0, y = 0;         ///< m, of its middle
    double gripX = 0, gripY = 0; ///< unit vector along which it grips the floor
    double share = 1; ///< cosine of the angle between that and the direction in which it rolls when its motor turns forwards
};

/// Converts between the motion of a base and that of its wheels.
class OmniKinematics {
public:
    OmniKinematics() = default;
    /// r: wheel radius, m. isComplete() is false where the wheels leave a motion open.
    OmniKinematics(double r, std::vector<FreeRollingWheel> wheels);

    [[nodiscard]] bool isComplete() const { return m_complete; }
    [[nodiscard]] const std::vector<FreeRollingWheel>& wheels() const { return m_wheels; }
    /// rad/s, or rad, of one wheel: the component along its grip of its middle's motion.
    [[nodiscard]] double wheelFromChassis(std::size_t wheel, const ChassisMotion& chassis) const;
    /// The motion that fits all wheels best (least squares). One number for each wheel.
    [[nodiscard]] ChassisMotion chassisFromWheels(const std::vector<double>& turned) const;
    /// The pose of the base whose wheels have these positions: x, y of each, m (least squares).
    [[nodiscard]] PlanePose poseFrom(const std::vector<std::array<double, 2>>& middles) const;

private:
    std::vector<FreeRollingWheel> m_wheels;
    std::vector<ChassisMotion> m_perWheel; ///< rows of the matrix from motion to wheels
    std::vector<ChassisMotion> m_inverse;  ///< columns of its pseudo-inverse
    bool m_complete = false;
};

} // namespace trundle
