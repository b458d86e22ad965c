#pragma once
#include <trundle/device.h>

namespace trundle {

/// A radio with its antenna at a pose on a body. Controllers send and receive packets through their RadioPort; the medium
/// (core/radio) simulates transmission. The signals published here are what a real driver could count.
class Transceiver final : public Device {
public:
    static void describe(Describe<Transceiver>& d);
    void setup(Mount& mount) override;
    void sense(Sensing& world) override;

private:
    std::string m_bodyName, m_antenna = "isotropic";
    std::array<double, 3> m_pos{0, 0, 0}, m_hpr{0, 0, 0};
    double m_maxOutputPower = 0, m_minReceivePower = -94, m_maxReceivePower = 0, m_rssiStep = 1, m_bitRate = 250000;
    int m_bufferLimit = 16, m_channel = 26, m_address = 0;
    std::vector<double> m_powerLevels, m_transmitCurrent;
    double m_receiveCurrent = 0, m_supply = 3;

    RadioId m_radio;
    OutputSlot<double> m_rssi, m_energy;
    OutputSlot<std::int64_t> m_ownAddress, m_lqi, m_pending, m_queued, m_sent, m_received, m_dropped, m_failed;
};

} // namespace trundle
