#pragma once
// The possible values of a property at an offset. Private to completion.

#include <string>
#include <string_view>
#include <vector>

#include "editor/text/completion/completion_item.h"
#include "editor/text/symbols/text_location.h"

namespace trundle {

/// For numbers only the default. `before`: the typed part of a name with dots or slashes ("chassis."), which the values continue;
/// `typed`: the same, in quotes all that is typed. `isOwn`: the value is of the block itself, not of what it overrides inside.
[[nodiscard]] std::vector<Completion> valuesOf(const LoadedProject& loaded, const TextLocation& place, const Property& property,
                                               const std::string& before, std::string_view typed, bool isOwn);

} // namespace trundle
