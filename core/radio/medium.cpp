#include "radio/medium.h"

#include <algorithm>
#include <cmath>
#include <limits>

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
    : m_settings(settings), m_layer(m_settings, m_radios, m_events), m_access(m_settings, m_radios, m_events, m_layer) {}

RadioId Medium::open(RadioDefinition definition) {
    const auto id = static_cast<RadioId>(m_radios.size());
    const auto taken = [&](std::uint32_t address) {
        return m_reserved.contains(address) || std::any_of(m_radios.begin(), m_radios.end(),
                                                           [&](const RadioState& r) { return r.definition.address == address; });
    };
    if (definition.address == 0)
        for (definition.address = id + 1; taken(definition.address);) ++definition.address;
    RadioState& radio = m_radios.emplace_back();
    radio.definition = std::move(definition);
    const RadioDefinition& d = radio.definition;
    radio.place = {id, fnv1a64(d.path), {}, d.antenna.get()};
    const RadioOffsets offsets = offsetsOf(m_settings, radio.place.key);
    radio.powerOffset = offsets.power;
    radio.readingOffset = offsets.reading;
    radio.clockFactor = offsets.clockFactor;
    m_byPath.emplace(d.path, id);
    m_layer.add(radio);
    return id;
}

void Medium::advance(std::int64_t until) {
    for (RadioId id = 0; id < m_radios.size(); ++id)
        if (!m_radios[id].queue.empty()) m_access.serve(id);
    for (RadioEvent event{}; m_events.take(until, event);) m_access.handle(event);
    m_layer.countEnergy();
}

std::optional<RadioId> Medium::find(std::string_view path) const {
    const auto it = m_byPath.find(std::string(path));
    if (it == m_byPath.end()) return std::nullopt;
    return it->second;
}

void Medium::switchOff(RadioId id) {
    RadioDefinition& definition = m_radios[id].definition;
    definition.bufferLimit = 0;
    definition.minReceivePower = std::numeric_limits<double>::infinity();
    definition.supply = 0;
}

bool Medium::send(RadioId id, std::span<const std::uint8_t> bytes, std::uint32_t to, double power) {
    RadioState& radio = m_radios[id];
    if (bytes.size() > kMaxPayload || !std::isfinite(power) || radio.queue.size() >= radio.definition.bufferLimit) {
        ++radio.counts.refused;
        return false;
    }
    const std::uint64_t number = radio.packets++;
    radio.queue.push_back({{bytes.begin(), bytes.end()}, to & 0xffff, power, static_cast<std::uint8_t>(number), number});
    return true;
}

bool Medium::receive(RadioId id, RadioPacket& packet) {
    RadioState& radio = m_radios[id];
    if (radio.inbox.empty()) return false;
    packet = std::move(radio.inbox.front());
    radio.inbox.pop_front();
    return true;
}

} // namespace trundle
