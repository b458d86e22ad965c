#pragma once
// What a radio wave loses on its way, in dB. Distances in m, frequency in Hz.

#include <cstdint>

#include <trundle/geometry.h>

namespace trundle {

inline constexpr double kNearest = 0.1; ///< m; closer antennas count as this far, or free space would give more than was sent

[[nodiscard]] double wavelength(double frequency);

/// Free space (Friis): 20 log10(4 pi d / lambda).
[[nodiscard]] double freeSpaceLoss(double distance, double lambda);

/// Direct ray and the one that the ground at z = 0 reflects. `permittivity` of the ground for vertical polarisation; 0: all is
/// reflected with its phase turned.
[[nodiscard]] double twoRayLoss(const Vec3& a, const Vec3& b, double lambda, double permittivity);

/// Free space to 1 m, from there 10 n dB per decade.
[[nodiscard]] double logDistanceLoss(double distance, double lambda, double exponent);

/// A standard normal number that belongs to a pair of radios and to where they stand: the same in both directions and in every run,
/// falling off as exp(-way / correlation) as one of them moves. `first` is the place of the radio with the lower key. At most 4 either way.
[[nodiscard]] double shadowing(std::uint64_t seed, std::uint64_t pair, const Vec3& first, const Vec3& second, double correlation);

} // namespace trundle
