#pragma once
#include <array>

#include <QString>

namespace trundle {

/// The available speeds: simulated s per s; 0 is as fast as possible and is last.
inline constexpr std::array<double, 8> kSpeeds{0.1, 0.25, 0.5, 1, 2, 5, 10, 0};

/// Index of the speed nearest to a factor.
[[nodiscard]] int speedIndex(double factor);
/// "0.25×", "max".
[[nodiscard]] QString speedText(double factor);
/// "t = 12.34 s"; from one hour on with hours and minutes: "t = 1:02:03.5".
[[nodiscard]] QString timeText(double seconds);
/// "41×", "0.98×".
[[nodiscard]] QString factorText(double factor);

} // namespace trundle
