#pragma once
#include <map>

#include "control/backend.h"
#include "host/record_sender.h"

namespace trundle {

/// The radios of a controller, asked for through the run.
class HostRadios final : public RadioAccess {
public:
    HostRadios(RecordSender& sender, std::uint32_t controller) : m_sender(sender), m_controller(controller) {}

    std::optional<std::uint32_t> find(const std::string& path) override;
    bool exists(std::uint32_t radio) const override { return m_known.contains(radio); }
    std::uint32_t address(std::uint32_t radio) const override { return m_known.at(radio).address; }
    bool send(std::uint32_t radio, std::span<const std::uint8_t> bytes, std::uint32_t to, double powerDbm) override;
    bool receive(std::uint32_t radio, RadioPacket& packet) override;
    std::size_t pending(std::uint32_t radio) const override { return m_known.at(radio).pending; }
    /// Packets in a radio's buffer in this tick, so that an empty one need not be asked.
    void setPending(std::uint32_t radio, std::size_t packets);

private:
    struct Known {
        std::uint32_t address = 0;
        std::size_t pending = 0;
    };
    RecordSender& m_sender;
    const std::uint32_t m_controller;
    std::map<std::uint32_t, Known> m_known;
};

/// What a controller asks of the run. The sender must outlive the result.
[[nodiscard]] ControllerOutputs makeHostOutputs(RecordSender& sender, std::uint32_t controller, std::shared_ptr<RadioAccess> radios);

} // namespace trundle
