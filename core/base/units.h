#pragma once
// The units of numbers in texts and their conversion.

#include <array>
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
/// Converts `value` from unit `from` to unit `to`; empty if a unit is unknown or the dimensions differ. Either may be a product of units, in SI.
[[nodiscard]] std::optional<double> convertUnit(double value, std::string_view from, std::string_view to);

/// The whole number that rounding has kept a quotient from, as .3/.1; others as they are.
[[nodiscard]] double wholeIfRounded(double value);

// Products and quotients of units: what "N/m" times "m" is.

/// Exponents of m, kg, s, A, K and rad.
using UnitExponents = std::array<int, 6>;
inline constexpr std::size_t kRadian = 5; ///< its index

/// Of a unit, of a product as unitOfProduct() writes it, or of "", a plain number. Empty for others, and for units that cannot be
/// multiplied: dB, degC, bit/s.
[[nodiscard]] std::optional<UnitExponents> exponentsOf(std::string_view unit);

/// The first unit of the only dimension with these exponents. If there are several, as for torque and energy, or none: the product in SI,
/// "m^2 kg/s^2", which converts to each that it may be. Angles are left out of such comparisons: "m rad/s" is a speed.
[[nodiscard]] std::string unitOfProduct(const UnitExponents& exponents);

/// Whether they are the same but for angles.
[[nodiscard]] bool isSameQuantity(const UnitExponents& a, const UnitExponents& b);

} // namespace trundle
