#pragma once
#include <cstdint>
#include <vector>

namespace trundle {

/// The order in which devices act: `peers[i]` are the devices whose signals device i bound, and i precedes each of them;
/// otherwise in index order. Devices in a cycle are left out, so a result shorter than `peers` indicates a cycle.
[[nodiscard]] std::vector<std::uint32_t> actingOrder(const std::vector<std::vector<std::uint32_t>>& peers);

} // namespace trundle
