#pragma once
// Random numbers as a function of where and when they are asked for, never a running stream: looking changes nothing, and a
// robot far away changes nobody's numbers.

#include <cstdint>
#include <string_view>

namespace trundle {

[[nodiscard]] std::uint64_t fnv1a64(std::string_view bytes, std::uint64_t start = 0xcbf29ce484222325ull);
/// 64 well-mixed bits of (seed, path, tick, index).
[[nodiscard]] std::uint64_t randomBits(std::uint64_t seed, std::uint64_t pathHash, std::uint64_t tick, std::uint64_t index);
/// [0, 1) from the top 53 bits.
[[nodiscard]] double toUnit(std::uint64_t bits);
/// Standard normal from two draws (Box-Muller).
[[nodiscard]] double toNormal(std::uint64_t a, std::uint64_t b);

} // namespace trundle
