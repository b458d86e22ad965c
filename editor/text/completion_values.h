#pragma once
// The values that a property may have at a place. Private to completion.

#include <string>
#include <vector>

#include "editor/text/completion.h"
#include "editor/text/text_place.h"

namespace trundle {

/// Numbers have none but their default. `before` is what is written of a dotted or slashed name already ("chassis.").
[[nodiscard]] std::vector<Completion> valuesOf(const Loaded& loaded, const TextPlace& place, const Property& property,
                                               const std::string& before);

} // namespace trundle
