#pragma once
// The units of numbers in texts and their conversion.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace trundle {

/// Units of one dimension convert into each other; dB, dBm and dBi are dimensions of their own.
struct UnitInfo {
    std::string_view name;      ///< as written: "cm"
    std::string_view dimension; ///< "length"
    double factor = 1;          ///< to the first unit of its dimension (SI; rad for angles, 1 for fractions, so "%" has 0.01)
};

[[nodiscard]] const UnitInfo* findUnit(std::string_view name);
[[nodiscard]] std::vector<std::string> allUnitNames();
/// Converts `value` from unit `from` to unit `to`; empty if a unit is unknown or the dimensions differ.
[[nodiscard]] std::optional<double> convertUnit(double value, std::string_view from, std::string_view to);

} // namespace trundle
