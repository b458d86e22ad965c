#include "radio/radio_nodes.h"

#include "base/rng.h"
#include "radio/ieee802154.h"

namespace trundle {

RadioNodes::RadioNodes(const MediumSettings& settings, std::vector<RadioNode> nodes)
    : m_settings(settings), m_links(settings), m_nodes(std::move(nodes)) {
    for (RadioId id = 0; id < m_nodes.size(); ++id) {
        const RadioDefinition& radio = m_nodes[id].radio;
        m_places.push_back({id, fnv1a64(radio.path), {}, radio.antenna.get()});
        m_offsets.push_back(offsetsOf(settings, m_places.back().key));
    }
}

std::optional<RadioId> RadioNodes::find(std::string_view path) const {
    for (RadioId id = 0; id < m_nodes.size(); ++id)
        if (m_nodes[id].radio.path == path) return id;
    return std::nullopt;
}

void RadioNodes::place(const std::vector<Pose>& bodies) {
    for (RadioId id = 0; id < m_nodes.size(); ++id)
        if (m_nodes[id].body < bodies.size()) m_places[id].pose = bodies[m_nodes[id].body] * m_nodes[id].mounting;
}

LinkReport RadioNodes::link(RadioId from, RadioId to, double power, std::uint32_t payload) const {
    const RadioDefinition &sender = m_nodes[from].radio, &receiver = m_nodes[to].radio;
    LinkReport report;
    report.outputPower = outputLevel(sender, power) + m_offsets[from].power;
    report.link = m_links.between(m_places[from], m_places[to], report.outputPower);
    report.rssi = rssiOf(receiver, report.link.power + m_offsets[to].reading);
    report.snr = report.link.power - m_settings.noiseFloor;
    report.lqi = linkQuality(report.snr);
    report.margin = report.link.power - receiver.minReceivePower;
    report.sameChannel = sender.channel == receiver.channel;
    if (report.margin < 0) report.packetLoss = 1;
    else if (m_settings.packetErrors)
        report.packetLoss = 1 - receptionRate(report.snr - m_settings.implementationLoss, 8.0 * (payload + kFrameOverhead));
    return report;
}

LinkBudget RadioNodes::reach(RadioId from, const AntennaPose& there, double power) const {
    return m_links.between(m_places[from], there, outputLevel(m_nodes[from].radio, power) + m_offsets[from].power);
}

} // namespace trundle
