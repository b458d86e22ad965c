#pragma once
// What one radio makes of a power that is wanted or that arrives.

#include "radio/radio_settings.h"

namespace trundle {

/// How one radio differs from its data sheet (RadioMedium's Offsets and ClockDrift); by the key of its path.
struct RadioOffsets {
    double power = 0, reading = 0; ///< dB
    double clockFactor = 1;
};
[[nodiscard]] RadioOffsets offsetsOf(const MediumSettings& settings, std::uint64_t key);

/// The strongest level that is not above what is wanted, dBm.
[[nodiscard]] double outputLevel(const RadioDefinition& radio, double wanted);
/// As read: not above its upper end, in its steps.
[[nodiscard]] double rssiOf(const RadioDefinition& radio, double power);

} // namespace trundle
