#pragma once
#include <array>
#include <cstdint>

namespace trundle {

using Rgb = std::array<std::uint8_t, 3>;

/// Sequential colour map from 0 (dark blue) to 1 (yellow), with increasing lightness, so that it is readable without colour
/// vision.
[[nodiscard]] Rgb heatColour(double share);

inline constexpr double kLobeFloor = -20, kLobeTop = 10; ///< dBi: radius 0 of a lobe, and the end of its colour scale
[[nodiscard]] Rgb gainColour(double gain);

inline constexpr double kSlimMargin = 3, kSafeMargin = 10; ///< dB above the sensitivity: end of red, start of green
[[nodiscard]] Rgb marginColour(double margin);

} // namespace trundle
