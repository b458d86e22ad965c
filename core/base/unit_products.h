#pragma once
// Dimensions of products and quotients of units: what "N/m" times "m" is.

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace trundle {

/// Exponents of m, kg, s, A, K and rad.
using UnitExponents = std::array<int, 6>;
inline constexpr std::size_t kRadian = 5; ///< its index

/// Of a unit (units.h), of a product as unitOfProduct() writes it, or of "", a plain number. Empty for others, and for units that cannot be
/// multiplied: dB, degC, bit/s.
[[nodiscard]] std::optional<UnitExponents> exponentsOf(std::string_view unit);

/// The first unit of the only dimension with these exponents. If there are several, as for torque and energy, or none: the product in SI,
/// "m^2 kg/s^2", which converts to each that it may be. Angles are left out of such comparisons: "m rad/s" is a speed.
[[nodiscard]] std::string unitOfProduct(const UnitExponents& exponents);

/// Whether they are the same but for angles.
[[nodiscard]] bool isSameQuantity(const UnitExponents& a, const UnitExponents& b);

} // namespace trundle
