#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "schema/kind.h"

namespace trundle {

/// The types of blocks that a block of this kind may be inside; "" is the top level. For devices, controllers and logs this depends
/// only on the role, whichever module defines them.
[[nodiscard]] std::vector<std::string> allowedParents(const Kind& kind);
[[nodiscard]] bool isAllowedInside(const Kind& kind, std::string_view parent);

} // namespace trundle
