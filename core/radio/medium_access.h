#pragma once
// Medium access. Without a protocol a radio sends at once, without listening. CSMA-CA: unslotted, IEEE 802.15.4-2006, 7.5.1.4 and
// 7.5.6; a packet for one address is acknowledged and sent again up to three times, with an interframe space between two packets
// of one sender.

#include "radio/physical_layer.h"

namespace trundle {

class MediumAccess {
public:
    /// All of these outlive this.
    MediumAccess(const MediumSettings& settings, std::vector<RadioState>& radios, RadioEvents& events, PhysicalLayer& layer)
        : m_settings(settings), m_radios(radios), m_events(events), m_layer(layer) {}

    /// Starts on the first queued packet if the radio is idle.
    void serve(RadioId radio);
    void handle(const RadioEvent& event);

private:
    void backOff(RadioId radio);
    void listenStart(RadioId radio);
    void listenEnd(RadioId radio);
    void sendStart(RadioId radio);
    void ackStart(RadioId radio);
    void ackTimeout(RadioId radio, std::uint32_t attempt);
    void frameEnd(std::uint32_t frame);
    void finish(RadioId radio);
    void acknowledged(RadioId radio, std::uint8_t sequence);

    const MediumSettings& m_settings;
    std::vector<RadioState>& m_radios;
    RadioEvents& m_events;
    PhysicalLayer& m_layer;
};

} // namespace trundle
