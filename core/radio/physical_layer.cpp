#include "radio/physical_layer.h"

#include <algorithm>
#include <cmath>

#include "base/rng.h"
#include "radio/radio_figures.h"

namespace trundle {

namespace {

constexpr double kNegligible = 10; ///< dB below the noise; weaker signals are ignored
constexpr double kAlone = 1e9;     ///< dB, signal-to-interference ratio without interference

double decibels(double ratio) { return 10 * std::log10(ratio); }

double sendCurrent(const RadioState& radio, double power) {
    const RadioDefinition& d = radio.definition;
    if (d.transmitCurrents.empty()) return 0;
    for (std::size_t i = 0; i < d.powerLevels.size() && i < d.transmitCurrents.size(); ++i)
        if (std::abs(d.powerLevels[i] + radio.powerOffset - power) < 1e-9) return d.transmitCurrents[i];
    return d.transmitCurrents.front();
}

} // namespace

PhysicalLayer::PhysicalLayer(const MediumSettings& settings, std::vector<RadioState>& radios, RadioEvents& events)
    : m_settings(settings), m_radios(radios), m_events(events), m_links(settings),
      m_noise(std::pow(10, settings.noiseFloor / 10)) {}

void PhysicalLayer::add(RadioState& radio) {
    const RadioDefinition& d = radio.definition;
    radio.current = d.receiveCurrent;
    radio.energyUntil = m_events.now();
    if (d.channel >= m_onChannel.size()) m_onChannel.resize(d.channel + 1);
    ++m_onChannel[d.channel];
    m_bestGain = std::max(m_bestGain, d.antenna ? d.antenna->peak() : 0.0);
    m_leastPower = std::min(m_leastPower, d.minReceivePower);
    m_neighbours.put(radio.place.id, Vec3::Zero());
}

void PhysicalLayer::place(RadioState& radio, const Pose& antenna) {
    radio.place.pose = antenna;
    m_neighbours.put(radio.place.id, antenna.position);
}

LinkBudget PhysicalLayer::link(const RadioState& from, const RadioState& to) const {
    return m_links.between(from.place, to.place, outputPower(from, from.definition.maxOutputPower));
}

std::shared_ptr<RadioTrace> PhysicalLayer::trace() {
    auto trace = std::make_shared<RadioTrace>();
    m_traces.push_back(trace);
    return trace;
}

/// The nearest level, plus this radio's offset.
double PhysicalLayer::outputPower(const RadioState& radio, double wanted) {
    return outputLevel(radio.definition, wanted) + radio.powerOffset;
}

/// Adds the energy used since the last change, then switches to a new current (A).
void PhysicalLayer::setCurrent(RadioState& radio, double current) {
    radio.counts.energy +=
        radio.definition.supply * radio.current * (static_cast<double>(m_events.now() - radio.energyUntil) * 1e-6);
    radio.energyUntil = m_events.now();
    radio.current = current;
}

void PhysicalLayer::countEnergy() {
    for (RadioState& radio : m_radios) setCurrent(radio, radio.current);
}

bool PhysicalLayer::channelBusy(const RadioState& radio) const {
    if (radio.sending || !radio.listening.empty()) return true;
    double power = m_noise;
    for (const IncidentSignal& i : radio.incidents) power += i.milliwatts;
    return 10 * std::log10(power) >= m_settings.carrierSense;
}

template <class Do> void PhysicalLayer::forTraces(const Do& with) {
    std::erase_if(m_traces, [](const std::weak_ptr<RadioTrace>& t) { return t.expired(); });
    for (const auto& weak : m_traces)
        if (const auto trace = weak.lock()) with(*trace);
}

std::uint32_t PhysicalLayer::freeFrame() {
    if (m_freeFrames.empty()) {
        m_freeFrames.push_back(static_cast<std::uint32_t>(m_frames.size()));
        m_frames.emplace_back();
    }
    const std::uint32_t index = m_freeFrames.back();
    m_freeFrames.pop_back();
    return index;
}

void PhysicalLayer::startFrame(RadioId sender, const OutgoingPacket& packet, bool ack) {
    const std::uint32_t index = freeFrame();
    RadioState& radio = m_radios[sender];
    MacFrame& frame = m_frames[index];
    frame = {sender, m_events.now(), 0, packet, ack, radio.frames++, outputPower(radio, packet.power), {}, {}};
    const auto mpdu = ack ? kAckBytes : static_cast<std::uint32_t>(packet.bytes.size()) + kFrameOverhead;
    frame.end = m_events.now() + airtimeUs(mpdu, radio.definition.bitRate);
    abortReception(sender);
    radio.sending = true;
    setCurrent(radio, sendCurrent(radio, frame.outputPower));
    if (!ack) ++radio.counts.sent;
    m_events.schedule(frame.end, RadioEventKind::FrameEnd, sender, index);
    forTraces([&](RadioTrace& trace) {
        const bool wantsAck = m_settings.csma && packet.to != kBroadcastAddress;
        trace.frames.push_back({static_cast<double>(m_events.now()) / 1e6, sender,
                                ack ? ackFrame(packet.sequence)
                                    : dataFrame(radio.definition.address, packet.to, packet.sequence, wantsAck, packet.bytes)});
    });
    arriveEverywhere(index);
}

/// Starts the reception of a frame at all radios of its channel that are near enough, and counts the others.
void PhysicalLayer::arriveEverywhere(std::uint32_t index) {
    const RadioId sender = m_frames[index].from;
    const RadioState& radio = m_radios[sender];
    const bool ack = m_frames[index].ack;
    const double least =
        m_settings.collisions || m_settings.csma ? std::min(m_leastPower, m_settings.noiseFloor - kNegligible) : m_leastPower;
    const double gain = radio.definition.antenna ? radio.definition.antenna->peak() : 0;
    const double range = m_links.range(m_frames[index].outputPower + gain + m_bestGain, least);
    const Vec3 place = radio.place.pose.position;
    m_neighbours.near(place, range, m_near);
    const std::uint32_t channel = radio.definition.channel;
    std::uint64_t heard = 0;
    for (const RadioId other : m_near) {
        if (other == sender || m_radios[other].definition.channel != channel) continue;
        if ((m_radios[other].place.pose.position - place).squaredNorm() > range * range) continue; // grid cells are coarse
        ++heard;
        if (!ack) ++m_expected, ++m_inTheAir;
        arrive(index, other);
    }
    if (ack) return;
    const std::uint64_t far = m_onChannel[channel] - 1 - heard;
    m_expected += far;
    m_outcomes[static_cast<std::size_t>(ReceptionOutcome::TooWeak)] += far;
}

/// Starts the reception of a frame at a radio, at the frame's first bit.
void PhysicalLayer::arrive(std::uint32_t index, RadioId id) {
    MacFrame& frame = m_frames[index];
    RadioState& radio = m_radios[id];
    Reception reception{id, m_links.between(m_radios[frame.from].place, radio.place, frame.outputPower)};
    reception.since = m_events.now();
    if (m_settings.collisions || m_settings.csma) {
        updateActiveReceptions(radio);
        radio.incidents.push_back({index, std::pow(10, reception.link.power / 10)});
        frame.incidentAt.push_back(id);
    }
    frame.receptions.push_back(reception);
    Reception& mine = frame.receptions.back();
    if (mine.link.power < radio.definition.minReceivePower) close(frame, mine, ReceptionOutcome::TooWeak);
    else if (radio.sending || radio.state == MacState::Turnaround) close(frame, mine, ReceptionOutcome::Sending);
    else if (m_settings.collisions && !radio.listening.empty() && !replaceWeaker(radio, mine))
        close(frame, mine, ReceptionOutcome::Busy);
    else radio.listening.push_back({index, static_cast<std::uint32_t>(frame.receptions.size() - 1)});
}

/// Of frames that begin in the same microsecond a receiver follows the strongest: true if it gives up the one that it follows.
bool PhysicalLayer::replaceWeaker(RadioState& radio, const Reception& reception) {
    const ActiveReception& followed = radio.listening.front();
    MacFrame& frame = m_frames[followed.frame];
    Reception& other = frame.receptions[followed.reception];
    if (frame.start != m_events.now() || !(other.link.power < reception.link.power)) return false;
    close(frame, other, ReceptionOutcome::Busy);
    radio.listening.clear();
    return true;
}

/// Ends all receptions of a radio that starts to send: it is half-duplex.
void PhysicalLayer::abortReception(RadioId id) {
    RadioState& radio = m_radios[id];
    updateActiveReceptions(radio);
    for (const ActiveReception& l : radio.listening)
        close(m_frames[l.frame], m_frames[l.frame].receptions[l.reception], ReceptionOutcome::Sending);
    radio.listening.clear();
}

/// Must be called before the set of incident signals at a radio changes.
void PhysicalLayer::updateActiveReceptions(RadioState& radio) {
    for (const ActiveReception& l : radio.listening)
        updateReception(radio, m_frames[l.frame], l.frame, m_frames[l.frame].receptions[l.reception]);
}

void PhysicalLayer::updateReception(const RadioState& radio, const MacFrame& frame, std::uint32_t index, Reception& reception) {
    if (m_events.now() == reception.since) return;
    double others = 0;
    if (m_settings.collisions)
        for (const IncidentSignal& i : radio.incidents)
            if (i.frame != index) others += i.milliwatts;
    const double power = reception.link.power, sinr = power - decibels(m_noise + others);
    reception.worstSinr = std::min(reception.worstSinr, sinr);
    reception.worstSir = std::min(reception.worstSir, others > 0 ? power - decibels(others) : kAlone);
    if (m_settings.packetErrors) {
        const double share = static_cast<double>(m_events.now() - reception.since) / static_cast<double>(frame.end - frame.start);
        const double bits = 8.0 * (frame.ack ? kAckBytes : static_cast<double>(frame.packet.bytes.size()) + kFrameOverhead);
        reception.success *= receptionRate(sinr - m_settings.implementationLoss, share * bits);
    }
    reception.since = m_events.now();
}

ReceptionOutcome PhysicalLayer::outcomeOf(const MacFrame& frame, const Reception& reception) const {
    if (m_settings.packetErrors) {
        const std::uint64_t a = m_radios[frame.from].place.key, b = m_radios[reception.radio].place.key;
        const std::uint64_t pair = randomBits(std::min(a, b), std::max(a, b), 0, 0);
        const double chance = toUnit(randomBits(m_settings.seed, pair, frame.number, a));
        if (chance < reception.success) return ReceptionOutcome::Delivered;
        const double bits = 8.0 * (frame.ack ? kAckBytes : static_cast<double>(frame.packet.bytes.size()) + kFrameOverhead);
        const double alone = reception.link.power - m_settings.noiseFloor - m_settings.implementationLoss;
        return chance < receptionRate(alone, bits) ? ReceptionOutcome::Collision : ReceptionOutcome::BitErrors;
    }
    return m_settings.collisions && reception.worstSir < m_settings.captureMargin ? ReceptionOutcome::Collision
                                                                                  : ReceptionOutcome::Delivered;
}

/// Sends an acknowledgement after the turnaround.
void PhysicalLayer::answer(RadioState& radio, const MacFrame& frame) {
    const std::uint32_t to = m_radios[frame.from].definition.address;
    radio.acks.push_back({{}, to, radio.definition.maxOutputPower, frame.packet.sequence});
    m_events.schedule(m_events.now() + kTurnaroundUs, RadioEventKind::AckStart, radio.place.id, 0);
}

/// Delivers a frame that was received without errors.
ReceptionOutcome PhysicalLayer::deliver(RadioState& radio, const MacFrame& frame, const Reception& reception, EndedFrame& ended) {
    const std::uint32_t mine = radio.definition.address, to = frame.packet.to;
    if (to != kBroadcastAddress && to != mine) return ReceptionOutcome::NotAddressed;
    if (frame.ack) {
        ended.acknowledged.push_back(radio.place.id);
        return ReceptionOutcome::Delivered;
    }
    const std::uint32_t from = m_radios[frame.from].definition.address;
    const bool answers = m_settings.csma && to == mine;
    if (answers) { // sequence numbers repeat: a duplicate is the same packet of its sender
        const auto last = radio.lastPacket.find(frame.from);
        if (last != radio.lastPacket.end() && last->second == frame.packet.number) {
            answer(radio, frame);
            return ReceptionOutcome::Duplicate;
        }
    }
    if (radio.inbox.size() >= radio.definition.bufferLimit) {
        ++radio.counts.dropped;
        return ReceptionOutcome::BufferFull;
    }
    ++radio.counts.received;
    radio.counts.lastRssi = rssiOf(radio.definition, reception.link.power + radio.readingOffset);
    radio.counts.lastLqi = linkQuality(reception.worstSinr);
    radio.inbox.push_back({static_cast<double>(m_events.now()) / 1e6 * radio.clockFactor, radio.counts.lastRssi,
                           radio.counts.lastLqi, from, to, frame.packet.sequence, frame.packet.bytes});
    if (answers) {
        radio.lastPacket[frame.from] = frame.packet.number;
        answer(radio, frame);
    }
    return ReceptionOutcome::Delivered;
}

void PhysicalLayer::close(const MacFrame& frame, Reception& reception, ReceptionOutcome outcome) {
    reception.open = false;
    if (!frame.ack) {
        ++m_outcomes[static_cast<std::size_t>(outcome)];
        --m_inTheAir;
    }
    if (!m_traces.empty()) record(frame, reception, outcome);
}

void PhysicalLayer::record(const MacFrame& frame, const Reception& reception, ReceptionOutcome outcome) {
    const RadioState& radio = m_radios[reception.radio];
    const double sinr = std::min(reception.worstSinr, reception.link.power - m_settings.noiseFloor);
    const FrameRecord r{static_cast<double>(frame.start) / 1e6,
                        frame.from,
                        reception.radio,
                        frame.ack,
                        frame.packet.sequence,
                        frame.packet.to,
                        static_cast<std::uint32_t>(frame.packet.bytes.size()),
                        frame.outputPower,
                        reception.link,
                        rssiOf(radio.definition, reception.link.power + radio.readingOffset),
                        sinr,
                        linkQuality(sinr),
                        outcome};
    forTraces([&](RadioTrace& trace) { trace.records.push_back(r); });
}

EndedFrame PhysicalLayer::endFrame(std::uint32_t index) {
    EndedFrame ended{m_frames[index].from, m_frames[index].ack, m_frames[index].packet.to, m_frames[index].packet.sequence, {}};
    for (std::size_t i = 0; i < m_frames[index].receptions.size(); ++i) {
        MacFrame& frame = m_frames[index];
        Reception& reception = frame.receptions[i];
        if (!reception.open) continue;
        RadioState& radio = m_radios[reception.radio];
        updateReception(radio, frame, index, reception);
        std::erase_if(radio.listening, [&](const ActiveReception& l) { return l.frame == index; });
        ReceptionOutcome outcome = outcomeOf(frame, reception);
        if (outcome == ReceptionOutcome::Delivered) outcome = deliver(radio, frame, reception, ended);
        close(frame, reception, outcome);
    }
    for (const RadioId id : m_frames[index].incidentAt) {
        updateActiveReceptions(m_radios[id]);
        std::erase_if(m_radios[id].incidents, [&](const IncidentSignal& i) { return i.frame == index; });
    }
    m_freeFrames.push_back(index);
    RadioState& radio = m_radios[ended.from];
    radio.sending = false;
    setCurrent(radio, radio.definition.receiveCurrent);
    return ended;
}

} // namespace trundle
