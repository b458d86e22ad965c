#pragma once
// Signals as table columns: angles in degrees, poses as position and heading, pitch, roll.

#include <span>
#include <string>
#include <vector>

#include "signals/layout.h"

namespace trundle {

/// Degrees rounded to 14 digits: 90, not 90.00000000000001 from the quaternion.
[[nodiscard]] double readableDegrees(double radians);

/// The meaning of a signal's slots, where Trundle itself defines more than its unit.
enum class SignalShape {
    Plain,     ///< by unit only
    Pose,      ///< x y z qw qx qy qz
    Velocity,  ///< linear and angular
    PlanePose, ///< x, y, heading
};
[[nodiscard]] SignalShape shapeOf(const SignalEntry& entry);

/// The columns of one signal: headings, and numbers for each row.
class SignalColumns {
public:
    explicit SignalColumns(const SignalEntry& entry);

    /// Headings: "robot0/leftEncoder/count", "robot0/pose/x [m]".
    [[nodiscard]] const std::vector<std::string>& names() const { return m_names; }
    /// Appends one number per column. `slots` is the whole signal block.
    void read(std::span<const double> slots, std::vector<double>& numbers) const;

private:
    SignalShape m_shape;
    bool m_isAngle = false;
    std::uint32_t m_offset, m_count;
    std::vector<std::string> m_names;
};

} // namespace trundle
