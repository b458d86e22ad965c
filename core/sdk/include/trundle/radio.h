// SPDX-License-Identifier: BSD-2-Clause
#pragma once
// Sending and receiving radio packets.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <trundle/abi.h>

namespace trundle {
inline namespace sdk1 {

/// A received packet.
struct Packet {
    std::vector<std::uint8_t> bytes;
    double rssi = 0; ///< dBm, as measured by the radio
    int lqi = 0;     ///< link quality: 110 at best, 50 where it can hardly be decoded
    double time = 0; ///< s, time of its last bit on the radio's own clock
    std::uint32_t from = 0, to = 0;
    [[nodiscard]] std::string_view text() const { return {reinterpret_cast<const char*>(bytes.data()), bytes.size()}; }
};

/// A Transceiver. A packet contains up to 116 bytes.
class RadioPort {
public:
    static constexpr std::uint32_t kEverybody = 0xffff;
    static constexpr double kFullPower = 1000; ///< dBm: the radio's maximum

    [[nodiscard]] bool bound() const { return m_border != nullptr; }
    /// 1 ... 65534, unique for each radio.
    [[nodiscard]] std::uint32_t address() const { return m_border ? m_border->address(m_context, m_radio) : 0; }

    /// Sends to one address, or broadcasts by default. Transmitted in this tick or after the packets queued before. False if the
    /// packet is too long or the queue is full.
    bool send(const void* bytes, std::size_t count, double powerDbm = kFullPower, std::uint32_t to = kEverybody) {
        return m_border && count <= TRUNDLE_MOST_PAYLOAD &&
               m_border->send(m_context, m_radio, static_cast<const std::uint8_t*>(bytes), static_cast<std::uint32_t>(count), to,
                              powerDbm) == 0;
    }
    bool send(const std::vector<std::uint8_t>& bytes, double powerDbm = kFullPower, std::uint32_t to = kEverybody) {
        return send(bytes.data(), bytes.size(), powerDbm, to);
    }
    bool send(std::string_view text, double powerDbm = kFullPower, std::uint32_t to = kEverybody) {
        return send(text.data(), text.size(), powerDbm, to);
    }

    /// The oldest packet in the queue; empty if there is none.
    [[nodiscard]] std::optional<Packet> receive() {
        TrundlePacket raw{};
        raw.size = sizeof raw;
        if (!m_border || m_border->receive(m_context, m_radio, &raw) == 0) return std::nullopt;
        return Packet{{raw.bytes, raw.bytes + raw.count}, raw.rssi, static_cast<int>(raw.lqi), raw.time, raw.from, raw.to};
    }

private:
    friend class RobotPorts;
    const TrundleRobotRadio* m_border = nullptr;
    void* m_context = nullptr;
    std::uint32_t m_radio = 0;
};

} // namespace sdk1
} // namespace trundle
