#pragma once
#include <span>
#include <string_view>

namespace trundle {

/// Level, voltage of a cell (V), and so on, by increasing level.
[[nodiscard]] std::span<const double> dischargeCurveOf(std::string_view chemistry);
/// Linear between two points; beyond the ends their voltage.
[[nodiscard]] double voltageAt(std::span<const double> curve, double level);

/// Pairs of a level from 0 to 1 and a voltage above 0, at least two, by increasing level.
[[nodiscard]] bool isDischargeCurve(std::span<const double> curve);

} // namespace trundle
