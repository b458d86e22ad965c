#pragma once
#include <cstdint>
#include <vector>

namespace trundle {

/// Order in which devices act: `peers[i]` are those whose signals device i bound, and i comes before each of them; otherwise as
/// numbered. Devices in a circle are left out, so a result shorter than `peers` means there is one.
[[nodiscard]] std::vector<std::uint32_t> actingOrder(const std::vector<std::vector<std::uint32_t>>& peers);

} // namespace trundle
