#include "base/rng.h"

#include <cmath>
#include <numbers>

namespace trundle {
namespace {

/// The finalizer of SplitMix64: every input bit affects every output bit.
std::uint64_t mix(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15ull;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
    return x ^ (x >> 31);
}

} // namespace

std::uint64_t fnv1a64(std::string_view bytes, std::uint64_t start) {
    std::uint64_t hash = start;
    for (const char c : bytes) {
        hash ^= static_cast<unsigned char>(c);
        hash *= 0x100000001b3ull;
    }
    return hash;
}

std::uint64_t randomBits(std::uint64_t seed, std::uint64_t pathHash, std::uint64_t tick, std::uint64_t index) {
    // Chained instead of xored: (seed 1, tick 2) and (seed 2, tick 1) must give different numbers.
    return mix(mix(mix(mix(seed) ^ pathHash) ^ tick) ^ index);
}

double toUnit(std::uint64_t bits) { return static_cast<double>(bits >> 11) * 0x1.0p-53; }

double toNormal(std::uint64_t a, std::uint64_t b) {
    const double u = 1.0 - toUnit(a); // in (0, 1], so that its logarithm is finite
    return std::sqrt(-2.0 * std::log(u)) * std::cos(2.0 * std::numbers::pi * toUnit(b));
}

} // namespace trundle
