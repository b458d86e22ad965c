#pragma once
// Converts the elements of a value, as written, into the value of a property: converts units, checks ranges and reports errors.

#include <optional>

#include "base/diagnostic.h"
#include "schema/given_value.h"
#include "schema/kind.h"

namespace trundle {

/// The note on an error in a value that comes from a Param; it refers to the value itself.
inline constexpr const char* kGivenHere = "the value is given here";
/// The note on an error at the value that an instance gives; it refers to the property that takes it.
inline constexpr const char* kUsedHere = "it is used here";

/// The value of the property; empty after reporting what is wrong (E202-E207). The name of a reference is not resolved here.
[[nodiscard]] std::optional<PropertyValue> readValue(const Property& property, const GivenValue& given, Diagnostics& diagnostics);

} // namespace trundle
