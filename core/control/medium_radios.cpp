#include "control/medium_radios.h"

#include "radio/medium.h"

namespace trundle {
namespace {

class MediumRadios final : public RadioAccess {
public:
    explicit MediumRadios(Medium& medium) : m_medium(medium) {}

    std::optional<std::uint32_t> find(const std::string& path) override { return m_medium.find(path); }
    bool exists(std::uint32_t radio) const override { return radio < m_medium.radioCount(); }
    std::uint32_t address(std::uint32_t radio) const override { return m_medium.radio(radio).address; }
    bool send(std::uint32_t radio, std::span<const std::uint8_t> bytes, std::uint32_t to, double powerDbm) override {
        return m_medium.send(radio, bytes, to, powerDbm);
    }
    bool receive(std::uint32_t radio, RadioPacket& packet) override { return m_medium.receive(radio, packet); }
    std::size_t pending(std::uint32_t radio) const override { return m_medium.pending(radio); }

private:
    Medium& m_medium;
};

} // namespace

std::shared_ptr<RadioAccess> radiosOf(Medium& medium) { return std::make_shared<MediumRadios>(medium); }

} // namespace trundle
