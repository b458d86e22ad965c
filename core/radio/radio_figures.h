#pragma once
// Output power and RSSI readings of one radio.

#include "radio/radio_settings.h"

namespace trundle {

/// Deviations of one radio from its data sheet (RadioMedium's Offsets and ClockDrift), derived from the key of its path.
struct RadioOffsets {
    double power = 0, reading = 0; ///< dB
    double clockFactor = 1;
};
[[nodiscard]] RadioOffsets offsetsOf(const MediumSettings& settings, std::uint64_t key);

/// The highest level (dBm) that is not above `wanted`.
[[nodiscard]] double outputLevel(const RadioDefinition& radio, double wanted);
/// RSSI (dBm) as the radio reads it: a multiple of its resolution up to its upper limit.
[[nodiscard]] double rssiOf(const RadioDefinition& radio, double power);

} // namespace trundle
