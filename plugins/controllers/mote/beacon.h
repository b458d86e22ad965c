#pragma once
// The packet that motes send to each other and to passing robots: the distance to the target, in hops and by link quality.

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

/// Numbers are sent in big-endian order.
struct Beacon {
    static constexpr std::uint8_t kMark = 0xb1;
    static constexpr std::uint16_t kUnknown = 0xffff;

    std::uint16_t flood = 0;       ///< number of the target's flood from which the other values come
    std::uint8_t hops = 0;         ///< number of hops to the target
    std::uint16_t cost = kUnknown; ///< 10 for a good hop, more for a weak one; summed over the hops

    [[nodiscard]] std::vector<std::uint8_t> bytes() const {
        const auto high = [](std::uint16_t v) { return static_cast<std::uint8_t>(v >> 8); };
        const auto low = [](std::uint16_t v) { return static_cast<std::uint8_t>(v & 0xff); };
        return {kMark, high(flood), low(flood), hops, high(cost), low(cost)};
    }
    [[nodiscard]] static std::optional<Beacon> from(const std::vector<std::uint8_t>& b) {
        if (b.size() != 6 || b[0] != kMark) return std::nullopt;
        return Beacon{static_cast<std::uint16_t>(b[1] << 8 | b[2]), b[3], static_cast<std::uint16_t>(b[4] << 8 | b[5])};
    }
    [[nodiscard]] bool knowsTarget() const { return cost != kUnknown; }
};
