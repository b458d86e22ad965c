// SPDX-License-Identifier: BSD-2-Clause
#pragma once
// Packets by radio.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <trundle/abi.h>

namespace trundle {
inline namespace sdk1 {

/// What a radio received.
struct Packet {
    std::vector<std::uint8_t> bytes;
    double rssi = 0; ///< dBm, as the radio reads it
    int lqi = 0;     ///< 110 at best, 50 where it can hardly be decoded
    double time = 0; ///< s, of its last bit, by the radio's own clock
    std::uint32_t from = 0, to = 0;
    [[nodiscard]] std::string_view text() const { return {reinterpret_cast<const char*>(bytes.data()), bytes.size()}; }
};

/// A Transceiver. A packet holds up to 116 bytes.
class RadioPort {
public:
    static constexpr std::uint32_t kEverybody = 0xffff;
    static constexpr double kFullPower = 1000; ///< dBm: as much as it can

    [[nodiscard]] bool bound() const { return m_border != nullptr; }
    /// 1 ... 65534, different for each radio.
    [[nodiscard]] std::uint32_t address() const { return m_border ? m_border->address(m_context, m_radio) : 0; }

    /// To all who hear it, or to one address. It goes out in this tick, or when those before it are out. False: too long, or too many
    /// wait already.
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

    /// The oldest packet that waits; nothing where none does.
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
