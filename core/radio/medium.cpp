#include "radio/medium.h"

#include <algorithm>
#include <cmath>

#include "base/rng.h"
#include "radio/radio_figures.h"

namespace trundle {

std::string_view outcomeName(ReceptionOutcome outcome) {
    switch (outcome) {
    case ReceptionOutcome::Delivered: return "delivered";
    case ReceptionOutcome::NotAddressed: return "not for it";
    case ReceptionOutcome::TooWeak: return "too weak";
    case ReceptionOutcome::Sending: return "was sending";
    case ReceptionOutcome::Busy: return "heard another";
    case ReceptionOutcome::Collision: return "collision";
    case ReceptionOutcome::BitErrors: return "bit errors";
    case ReceptionOutcome::BufferFull: return "buffer full";
    case ReceptionOutcome::Duplicate: return "duplicate";
    }
    return "";
}

Medium::Medium(const MediumSettings& settings)
    : m_settings(settings), m_links(settings), m_noise(std::pow(10, settings.noiseFloor / 10)) {}

RadioId Medium::open(RadioDefinition definition) {
    const auto id = static_cast<RadioId>(m_radios.size());
    const auto taken = [&](std::uint32_t address) {
        return std::any_of(m_radios.begin(), m_radios.end(), [&](const Radio& r) { return r.definition.address == address; });
    };
    if (definition.address == 0)
        for (definition.address = id + 1; taken(definition.address);) ++definition.address;
    Radio& radio = m_radios.emplace_back();
    radio.definition = std::move(definition);
    const RadioDefinition& d = radio.definition;
    radio.place = {id, fnv1a64(d.path), {}, d.antenna.get()};
    const RadioOffsets offsets = offsetsOf(m_settings, radio.place.key);
    radio.powerOffset = offsets.power;
    radio.readingOffset = offsets.reading;
    radio.clockFactor = offsets.clockFactor;
    radio.current = d.receiveCurrent;
    radio.energyUntil = m_now;
    m_byPath.emplace(d.path, id);
    if (d.channel >= m_onChannel.size()) m_onChannel.resize(d.channel + 1);
    ++m_onChannel[d.channel];
    m_bestGain = std::max(m_bestGain, d.antenna ? d.antenna->peak() : 0.0);
    m_leastPower = std::min(m_leastPower, d.minReceivePower);
    m_neighbours.put(id, Vec3::Zero());
    return id;
}

void Medium::place(RadioId radio, const Pose& antenna) {
    m_radios[radio].place.pose = antenna;
    m_neighbours.put(radio, antenna.position);
}

void Medium::advance(std::int64_t until) {
    for (RadioId id = 0; id < m_radios.size(); ++id)
        if (!m_radios[id].queue.empty()) serve(id);
    while (!m_events.empty() && m_events.top().at < until) {
        const Event event = m_events.top();
        m_events.pop();
        m_now = event.at;
        handle(event);
    }
    m_now = std::max(m_now, until);
    for (Radio& radio : m_radios) setCurrent(radio, radio.current);
}

std::optional<RadioId> Medium::find(std::string_view path) const {
    const auto it = m_byPath.find(std::string(path));
    if (it == m_byPath.end()) return std::nullopt;
    return it->second;
}

bool Medium::send(RadioId id, std::span<const std::uint8_t> bytes, std::uint32_t to, double power) {
    Radio& radio = m_radios[id];
    if (bytes.size() > kMaxPayload || !std::isfinite(power) || radio.queue.size() >= radio.definition.bufferLimit) {
        ++radio.counts.refused;
        return false;
    }
    radio.queue.push_back({{bytes.begin(), bytes.end()}, to & 0xffff, power, radio.nextSequence++});
    return true;
}

bool Medium::receive(RadioId id, RadioPacket& packet) {
    Radio& radio = m_radios[id];
    if (radio.inbox.empty()) return false;
    packet = std::move(radio.inbox.front());
    radio.inbox.pop_front();
    return true;
}

LinkBudget Medium::link(RadioId from, RadioId to) const {
    const Radio& sender = m_radios[from];
    return m_links.between(sender.place, m_radios[to].place, outputPower(sender, sender.definition.maxOutputPower));
}

std::shared_ptr<RadioTrace> Medium::trace() {
    auto trace = std::make_shared<RadioTrace>();
    m_traces.push_back(trace);
    return trace;
}

/// The nearest level, plus this radio's offset.
double Medium::outputPower(const Radio& radio, double wanted) const {
    return outputLevel(radio.definition, wanted) + radio.powerOffset;
}

double Medium::sendCurrent(const Radio& radio, double power) const {
    const RadioDefinition& d = radio.definition;
    if (d.transmitCurrents.empty()) return 0;
    for (std::size_t i = 0; i < d.powerLevels.size() && i < d.transmitCurrents.size(); ++i)
        if (std::abs(d.powerLevels[i] + radio.powerOffset - power) < 1e-9) return d.transmitCurrents[i];
    return d.transmitCurrents.front();
}

/// Adds the energy used since the last change, then switches to a new current (A).
void Medium::setCurrent(Radio& radio, double current) {
    radio.counts.energy += radio.definition.supply * radio.current * (static_cast<double>(m_now - radio.energyUntil) * 1e-6);
    radio.energyUntil = m_now;
    radio.current = current;
}

} // namespace trundle
