#pragma once
// Trace of what happened on the medium, for logs and windows. Reading it does not affect the simulation.

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace trundle {

using RadioId = std::uint32_t;
inline constexpr RadioId kNoRadio = 0xffffffffu;

/// Result of a frame at one receiver.
enum class ReceptionOutcome {
    Delivered,
    NotAddressed, ///< received, but addressed to another radio
    TooWeak,      ///< below MinReceivePower
    Sending,      ///< the receiver was sending or switching to send
    Busy,         ///< the receiver was locked on to another frame
    Collision,    ///< another frame was too strong
    BitErrors,
    BufferFull,
    Duplicate, ///< received before; its acknowledgement was lost
};
inline constexpr std::size_t kReceptionOutcomes = 9;
/// The name of an outcome: "delivered", "too weak" ...
[[nodiscard]] std::string_view outcomeName(ReceptionOutcome outcome);

/// Terms of a link budget, dB, dBm, dBi.
struct LinkBudget {
    double distance = 0;
    double sendGain = 0, receiveGain = 0;
    double pathLoss = 0; ///< of the propagation model
    double shadow = 0;   ///< added to the loss
    double wallLoss = 0;
    double power = 0; ///< received, dBm
};

/// One frame at one receiver.
struct FrameRecord {
    double time = 0; ///< s, arrival of its first bit
    RadioId from = kNoRadio, to = kNoRadio;
    bool ack = false;
    std::uint8_t sequence = 0;
    std::uint32_t address = 0, bytes = 0; ///< destination; bytes of the payload
    double outputPower = 0;
    LinkBudget link;
    double rssi = 0, sinr = 0;
    int lqi = 0;
    ReceptionOutcome outcome = ReceptionOutcome::Delivered;
};

/// One frame as received by a sniffer next to its sender.
struct AirFrame {
    double time = 0;
    RadioId from = kNoRadio;
    std::vector<std::uint8_t> bytes; ///< MPDU
};

struct RadioTrace {
    std::vector<FrameRecord> records; ///< in the order of their ends; cleared by the reader
    std::vector<AirFrame> frames;
};

} // namespace trundle
