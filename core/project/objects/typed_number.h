#pragma once
#include <string>

#include "base/result.h"
#include "schema/kind.h"

namespace trundle {

/// The number that a typed text gives a property, in SI: "0.35", "20 cm", "1/4"; with the reason if it gives none.
[[nodiscard]] Result<double> typedNumber(const std::string& typed, const Property& property);

} // namespace trundle
