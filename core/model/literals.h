#pragma once
// What is written out in a text, without Params: elements, and numbers in the units of plain numbers.

#include <optional>
#include <string>
#include <string_view>

#include "lang/tree.h"
#include "schema/given_value.h"

namespace trundle {

inline constexpr double kUnitRounding = 1e-12; ///< of a conversion between units, relative

/// An element that is written out; of others only where it is.
[[nodiscard]] GivenElement literalOf(const Element& element, FileId file);

/// The unit in which expressions hold amounts of a dimension: m, deg, deg/s ...
[[nodiscard]] std::string baseUnit(std::string_view dimension);
/// The unit of plain numbers of a dimension in the language, that of its properties: m, deg, rad/s ...
[[nodiscard]] std::string plainUnit(std::string_view dimension);
/// A number in that unit; as it is where its unit is unknown.
[[nodiscard]] std::optional<double> plainNumber(const GivenElement& element);
/// Whether both are the same number, word or text: 10 ms and 0.01 are.
[[nodiscard]] bool areEqual(const GivenElement& a, const GivenElement& b);

} // namespace trundle
