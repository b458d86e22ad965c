#pragma once
// Propagation losses in dB. Distances in m, frequency in Hz.

#include <cstdint>

#include <trundle/geometry.h>

namespace trundle {

inline constexpr double kNearest = 0.1; ///< m; shorter distances count as this, since free space would give a gain

[[nodiscard]] double wavelength(double frequency);

/// Free space (Friis): 20 log10(4 pi d / lambda).
[[nodiscard]] double freeSpaceLoss(double distance, double lambda);

/// Direct ray and ground reflection at z = 0. `permittivity` of the ground for vertical polarisation; 0: total reflection with
/// inverted phase.
[[nodiscard]] double twoRayLoss(const Vec3& a, const Vec3& b, double lambda, double permittivity);

/// Free space up to 1 m, then 10 n dB per decade.
[[nodiscard]] double logDistanceLoss(double distance, double lambda, double exponent);

/// A standard normal number determined by a pair of radios and their positions: the same in both directions and in every run,
/// with correlation exp(-distance / correlation) as one of them moves. `first` is the position of the radio with the lower key.
/// At most 4 in magnitude.
[[nodiscard]] double shadowing(std::uint64_t seed, std::uint64_t pair, const Vec3& first, const Vec3& second, double correlation);

} // namespace trundle
