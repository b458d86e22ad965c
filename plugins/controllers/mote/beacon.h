#pragma once
// What motes tell each other and a robot that passes: how far it is to the target, by hops and by the quality of the links.

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

/// Numbers go in big-endian order.
struct Beacon {
    static constexpr std::uint8_t kMark = 0xb1;
    static constexpr std::uint16_t kUnknown = 0xffff;

    std::uint16_t flood = 0;       ///< number of the target's flood that the rest comes from
    std::uint8_t hops = 0;         ///< to the target
    std::uint16_t cost = kUnknown; ///< 10 for a good hop, more for a weak one; summed up

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
