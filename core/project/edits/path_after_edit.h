#pragma once
#include <optional>
#include <string>

#include "project/loading/project.h"

namespace trundle {

/// The path of the same object after an edit of the texts: another one if the object, or one that contains it, was renamed, by
/// whatever kind of edit. A missing block counts as renamed if as many siblings exist as before, and the one at its index has
/// its kind and a new name. Nothing if the object no longer exists.
[[nodiscard]] std::optional<std::string> pathAfterEdit(const LoadedProject& before, const LoadedProject& after,
                                                       const std::string& path);

} // namespace trundle
