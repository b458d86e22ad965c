#pragma once
// Descriptions of a property for completion and tooltips.

#include <string>

#include "schema/kind.h"

namespace trundle {

/// "m", "three numbers in m", "servo, pi or voltage", "name of a Hinge or Suspension".
[[nodiscard]] std::string typeText(const Property& property);
/// As it would be written: "0.01", "0, 0, -9.81", "servo". Empty if there is none.
[[nodiscard]] std::string defaultText(const Property& property);
/// Type, range and default in one line: "m, above 0, default 0.1, required".
[[nodiscard]] std::string factsText(const Property& property);

} // namespace trundle
