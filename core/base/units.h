#pragma once
// Units that a number in a text may carry, and what they convert to.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace trundle {

/// Units of one dimension convert into each other; dB, dBm and dBi are dimensions of their own.
struct UnitInfo {
    std::string_view name;      ///< as written: "cm"
    std::string_view dimension; ///< "length"
    double factor = 1;          ///< to the dimension's first unit (SI; rad for angles, 1 for "%": 0.01)
};

[[nodiscard]] const UnitInfo* findUnit(std::string_view name);
[[nodiscard]] std::vector<std::string> allUnitNames();
/// `value` in `from` expressed in `to`; nothing when a unit is unknown or the dimensions differ.
[[nodiscard]] std::optional<double> convertUnit(double value, std::string_view from, std::string_view to);

} // namespace trundle
