#pragma once
// IEEE 802.15.4 at 2.4 GHz: timing, error rates and the bytes of frames.

#include <cstdint>
#include <span>
#include <vector>

namespace trundle {

inline constexpr std::uint32_t kBroadcastAddress = 0xffff;
inline constexpr std::uint32_t kFrameOverhead = 11; ///< bytes of a data frame besides its payload: 9 before, 2 after
inline constexpr std::uint32_t kMaxPayload = 127 - kFrameOverhead;
inline constexpr std::uint32_t kAckBytes = 5;

// Unslotted CSMA-CA (IEEE 802.15.4-2006, 7.5.1.4), us.
inline constexpr std::int64_t kBackoffUnitUs = 320, kListenUs = 128, kTurnaroundUs = 192, kAckWaitUs = 864;
// Interframe spacing of one sender: the long one after more than 18 bytes (7.5.1.3, 6.4.1), us.
inline constexpr std::int64_t kShortSpaceUs = 192, kLongSpaceUs = 640;
inline constexpr std::uint32_t kMaxBytesForShortSpace = 18;
inline constexpr int kLeastExponent = 3, kMaxExponent = 5, kMaxBackoffs = 4, kMaxRetries = 3;

/// Bit error rate of O-QPSK with 16 spread symbols at a signal-to-noise ratio in dB (802.15.4-2006, E.4.1.8).
[[nodiscard]] double bitErrorRate(double sinrDb);
/// Probability that `bits` bits arrive without an error.
[[nodiscard]] double receptionRate(double sinrDb, double bits);

/// Airtime (us) of a frame of `mpduBytes`, including six bytes of preamble, start and length before it.
[[nodiscard]] std::int64_t airtimeUs(std::uint32_t mpduBytes, double bitRate);

/// Link quality as the chip correlation that a CC2420 reports: about 110 for the best frames, 50 for the worst that it can
/// decode.
[[nodiscard]] int linkQuality(double sinrDb);

/// The bytes of a data frame (MPDU), including the check sequence; short addresses in one network.
[[nodiscard]] std::vector<std::uint8_t> dataFrame(std::uint32_t from, std::uint32_t to, std::uint8_t sequence, bool wantsAck,
                                                  std::span<const std::uint8_t> payload);
[[nodiscard]] std::vector<std::uint8_t> ackFrame(std::uint8_t sequence);

} // namespace trundle
