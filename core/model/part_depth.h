#pragma once
#include <cstddef>

namespace trundle {

/// How deep PartConfigs may be nested: limits the stack.
inline constexpr std::size_t kDeepestParts = 100; // with the config that holds them

} // namespace trundle
