#pragma once
// What is written out in a text, without Params: elements, and numbers in the units of plain numbers.

#include <string>
#include <string_view>

#include "lang/tree.h"
#include "schema/given_value.h"

namespace trundle {

/// An element that is written out; of others only where it is.
[[nodiscard]] GivenElement literalOf(const Element& element, FileId file);

/// The unit in which expressions hold amounts of a dimension: m, deg, deg/s ...
[[nodiscard]] std::string baseUnit(std::string_view dimension);
/// The unit of plain numbers of a dimension in the language, that of its properties: m, deg, rad/s ...
[[nodiscard]] std::string plainUnit(std::string_view dimension);

} // namespace trundle
