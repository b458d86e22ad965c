#pragma once
// How a signal looks outside the program: angles in degrees, poses as position and heading, pitch, roll.

#include <span>
#include <string>
#include <vector>

#include "signals/layout.h"

namespace trundle {

/// Degrees as people read them: 90, where the quaternion behind it gives 90.00000000000001. 14 digits are kept.
[[nodiscard]] double readableDegrees(double radians);

/// What the slots of a signal are, where its name says more than its unit.
enum class SignalShape {
    Plain,     ///< as its unit says
    Pose,      ///< x y z qw qx qy qz
    Velocity,  ///< linear and angular
    PlanePose, ///< x, y, heading
};
[[nodiscard]] SignalShape shapeOf(const SignalEntry& entry);

/// The columns of one signal: their headings and, per row, their numbers.
class SignalColumns {
public:
    explicit SignalColumns(const SignalEntry& entry);

    /// "robot0/leftEncoder/count", "robot0/pose/x [m]".
    [[nodiscard]] const std::vector<std::string>& names() const { return m_names; }
    /// Appends as many numbers as there are names. `slots` is the whole block.
    void read(std::span<const double> slots, std::vector<double>& numbers) const;

private:
    SignalShape m_shape;
    bool m_isAngle = false;
    std::uint32_t m_offset, m_count;
    std::vector<std::string> m_names;
};

} // namespace trundle
