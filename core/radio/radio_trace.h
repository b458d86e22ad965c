#pragma once
// What happened in the air, for logs and windows. Whoever reads it changes nothing.

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace trundle {

using RadioId = std::uint32_t;
inline constexpr RadioId kNoRadio = 0xffffffffu;

/// What became of a frame at one receiver.
enum class Fate {
    Delivered,
    NotForIt,  ///< received, but addressed to another
    TooWeak,   ///< below MinReceivePower
    Sending,   ///< the receiver was sending or turning to send
    Busy,      ///< the receiver held on to another frame
    Collision, ///< another frame was too strong
    BitErrors,
    BufferFull,
    Duplicate, ///< received before; the acknowledgement was lost
};
inline constexpr std::size_t kFates = 9;
/// "delivered", "too weak" ...
[[nodiscard]] std::string_view fateName(Fate fate);

/// A link's terms, dB, dBm, dBi.
struct LinkBudget {
    double distance = 0;
    double sendGain = 0, receiveGain = 0;
    double pathLoss = 0; ///< of the model
    double shadow = 0;   ///< added to the loss
    double wallLoss = 0;
    double power = 0; ///< at the receiver
};

/// One frame at one receiver.
struct FrameRecord {
    double time = 0; ///< s, of its first bit
    RadioId from = kNoRadio, to = kNoRadio;
    bool ack = false;
    std::uint8_t sequence = 0;
    std::uint32_t address = 0, bytes = 0; ///< addressed to; payload
    double outputPower = 0;
    LinkBudget link;
    double rssi = 0, sinr = 0;
    int lqi = 0;
    Fate fate = Fate::Delivered;
};

/// One frame as a sniffer next to its sender sees it.
struct AirFrame {
    double time = 0;
    RadioId from = kNoRadio;
    std::vector<std::uint8_t> bytes; ///< MPDU
};

struct RadioTrace {
    std::vector<FrameRecord> records; ///< in the order of their ends; the reader empties it
    std::vector<AirFrame> frames;
};

} // namespace trundle
