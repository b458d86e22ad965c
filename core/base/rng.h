#pragma once
// Random numbers as a function of seed, path, tick and index instead of a stream: reading one has no side effect, and one robot's
// draws never change another's.

#include <cstdint>
#include <string_view>

namespace trundle {

[[nodiscard]] std::uint64_t fnv1a64(std::string_view bytes, std::uint64_t start = 0xcbf29ce484222325ull);
/// 64 well-mixed bits of (seed, path, tick, index).
[[nodiscard]] std::uint64_t randomBits(std::uint64_t seed, std::uint64_t pathHash, std::uint64_t tick, std::uint64_t index);
/// Maps the top 53 bits to [0, 1).
[[nodiscard]] double toUnit(std::uint64_t bits);
/// A standard normal number from two uniform draws (Box-Muller).
[[nodiscard]] double toNormal(std::uint64_t a, std::uint64_t b);

} // namespace trundle
