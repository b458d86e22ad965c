#pragma once
#include <array>
#include <cstdint>

namespace trundle {

using Rgb = std::array<std::uint8_t, 3>;

/// From little (0, dark blue) to much (1, yellow), lighter all the way: to be told apart without colours too.
[[nodiscard]] Rgb heatColour(double share);

inline constexpr double kLobeFloor = -20, kLobeTop = 10; ///< dBi: where a lobe has no radius, and where its colours end
[[nodiscard]] Rgb gainColour(double gain);

inline constexpr double kSlimMargin = 3, kSafeMargin = 10; ///< dB over the sensitivity, where red ends and green begins
[[nodiscard]] Rgb marginColour(double margin);

} // namespace trundle
