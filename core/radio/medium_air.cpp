// Transmission and reception of frames. Needs: sender, poses of all radios. Assumptions: poses and gains are constant during a
// frame; a frame reaches all receivers at once (300 m are one microsecond); signals 10 dB below the noise are ignored. With
// collisions a receiver locks on to the first frame that it can decode; each interval with the same interfering frames then
// counts by its own signal-to-noise ratio.
#include <algorithm>
#include <cmath>

#include "base/rng.h"
#include "radio/medium.h"
#include "radio/radio_figures.h"

namespace trundle {

namespace {

constexpr double kNegligible = 10; ///< dB below the noise; weaker signals are ignored
constexpr double kAlone = 1e9;     ///< dB, signal-to-interference ratio without interference

double decibels(double ratio) { return 10 * std::log10(ratio); }

} // namespace

template <class Do> void Medium::forTraces(const Do& with) {
    std::erase_if(m_traces, [](const std::weak_ptr<RadioTrace>& t) { return t.expired(); });
    for (const auto& weak : m_traces)
        if (const auto trace = weak.lock()) with(*trace);
}

void Medium::startFrame(RadioId sender, const Outgoing& packet, bool ack) {
    if (m_freeFrames.empty()) {
        m_freeFrames.push_back(static_cast<std::uint32_t>(m_frames.size()));
        m_frames.emplace_back();
    }
    const std::uint32_t index = m_freeFrames.back();
    m_freeFrames.pop_back();
    Radio& radio = m_radios[sender];
    MacFrame& frame = m_frames[index];
    frame = {sender, m_now, 0, packet, ack, radio.frames++, outputPower(radio, packet.power), {}, {}};
    const auto mpdu = ack ? kAckBytes : static_cast<std::uint32_t>(packet.bytes.size()) + kFrameOverhead;
    frame.end = m_now + airtimeUs(mpdu, radio.definition.bitRate);
    abortReception(sender);
    radio.sending = true;
    setCurrent(radio, sendCurrent(radio, frame.outputPower));
    if (!ack) ++radio.counts.sent;
    schedule(frame.end, EventKind::FrameEnd, sender, index);
    forTraces([&](RadioTrace& trace) {
        const bool wantsAck = m_settings.csma && packet.to != kBroadcastAddress;
        trace.frames.push_back({static_cast<double>(m_now) * 1e-6, sender,
                                ack ? ackFrame(packet.sequence)
                                    : dataFrame(radio.definition.address, packet.to, packet.sequence, wantsAck, packet.bytes)});
    });

    const double least =
        m_settings.collisions || m_settings.csma ? std::min(m_leastPower, m_settings.noiseFloor - kNegligible) : m_leastPower;
    const double gain = radio.definition.antenna ? radio.definition.antenna->peak() : 0;
    const double range = m_links.range(frame.outputPower + gain + m_bestGain, least);
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
void Medium::arrive(std::uint32_t index, RadioId id) {
    MacFrame& frame = m_frames[index];
    Radio& radio = m_radios[id];
    Reception reception{id, m_links.between(m_radios[frame.from].place, radio.place, frame.outputPower)};
    reception.since = m_now;
    if (m_settings.collisions || m_settings.csma) {
        updateActiveReceptions(radio);
        radio.incidents.push_back({index, std::pow(10, reception.link.power / 10)});
        frame.incidentAt.push_back(id);
    }
    frame.receptions.push_back(reception);
    Reception& mine = frame.receptions.back();
    if (mine.link.power < radio.definition.minReceivePower) close(frame, mine, ReceptionOutcome::TooWeak);
    else if (radio.sending || radio.state == MacState::Turnaround) close(frame, mine, ReceptionOutcome::Sending);
    else if (m_settings.collisions && !radio.listening.empty()) close(frame, mine, ReceptionOutcome::Busy);
    else radio.listening.push_back({index, static_cast<std::uint32_t>(frame.receptions.size() - 1)});
}

/// Ends all receptions of a radio that starts to send: it is half-duplex.
void Medium::abortReception(RadioId id) {
    Radio& radio = m_radios[id];
    updateActiveReceptions(radio);
    for (const ActiveReception& l : radio.listening)
        close(m_frames[l.frame], m_frames[l.frame].receptions[l.reception], ReceptionOutcome::Sending);
    radio.listening.clear();
}

/// Must be called before the set of incident signals at a radio changes.
void Medium::updateActiveReceptions(Radio& radio) {
    for (const ActiveReception& l : radio.listening)
        updateReception(radio, m_frames[l.frame], l.frame, m_frames[l.frame].receptions[l.reception]);
}

void Medium::updateReception(const Radio& radio, const MacFrame& frame, std::uint32_t index, Reception& reception) {
    if (m_now == reception.since) return;
    double others = 0;
    if (m_settings.collisions)
        for (const IncidentSignal& i : radio.incidents)
            if (i.frame != index) others += i.milliwatts;
    const double power = reception.link.power, sinr = power - decibels(m_noise + others);
    reception.worstSinr = std::min(reception.worstSinr, sinr);
    reception.worstSir = std::min(reception.worstSir, others > 0 ? power - decibels(others) : kAlone);
    if (m_settings.packetErrors) {
        const double share = static_cast<double>(m_now - reception.since) / static_cast<double>(frame.end - frame.start);
        const double bits = 8.0 * (frame.ack ? kAckBytes : static_cast<double>(frame.packet.bytes.size()) + kFrameOverhead);
        reception.success *= receptionRate(sinr - m_settings.implementationLoss, share * bits);
    }
    reception.since = m_now;
}

ReceptionOutcome Medium::outcomeOf(const MacFrame& frame, const Reception& reception) const {
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

/// Delivers a frame that was received without errors.
ReceptionOutcome Medium::deliver(Radio& radio, const MacFrame& frame, const Reception& reception) {
    const std::uint32_t mine = radio.definition.address, to = frame.packet.to;
    if (to != kBroadcastAddress && to != mine) return ReceptionOutcome::NotAddressed;
    if (frame.ack) {
        acknowledged(radio.place.id, frame);
        return ReceptionOutcome::Delivered;
    }
    const std::uint32_t from = m_radios[frame.from].definition.address;
    const bool answers = m_settings.csma && to == mine;
    const auto answer = [&] {
        radio.acks.push_back({{}, from, radio.definition.maxOutputPower, frame.packet.sequence});
        schedule(m_now + kTurnaroundUs, EventKind::AckStart, radio.place.id, 0);
    };
    if (answers) {
        const auto last = radio.lastSequence.find(from);
        if (last != radio.lastSequence.end() && last->second == frame.packet.sequence) {
            answer();
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
    radio.inbox.push_back({static_cast<double>(m_now) * 1e-6 * radio.clockFactor, radio.counts.lastRssi, radio.counts.lastLqi,
                           from, to, frame.packet.sequence, frame.packet.bytes});
    if (answers) {
        radio.lastSequence[from] = frame.packet.sequence;
        answer();
    }
    return ReceptionOutcome::Delivered;
}

void Medium::close(const MacFrame& frame, Reception& reception, ReceptionOutcome outcome) {
    reception.open = false;
    if (!frame.ack) {
        ++m_outcomes[static_cast<std::size_t>(outcome)];
        --m_inTheAir;
    }
    if (!m_traces.empty()) record(frame, reception, outcome);
}

void Medium::record(const MacFrame& frame, const Reception& reception, ReceptionOutcome outcome) {
    const Radio& radio = m_radios[reception.radio];
    const double sinr = std::min(reception.worstSinr, reception.link.power - m_settings.noiseFloor);
    const FrameRecord r{static_cast<double>(frame.start) * 1e-6,
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

void Medium::endFrame(std::uint32_t index) {
    const RadioId sender = m_frames[index].from;
    for (std::size_t i = 0; i < m_frames[index].receptions.size(); ++i) {
        MacFrame& frame = m_frames[index];
        Reception& reception = frame.receptions[i];
        if (!reception.open) continue;
        Radio& radio = m_radios[reception.radio];
        updateReception(radio, frame, index, reception);
        std::erase_if(radio.listening, [&](const ActiveReception& l) { return l.frame == index; });
        ReceptionOutcome outcome = outcomeOf(frame, reception);
        if (outcome == ReceptionOutcome::Delivered) outcome = deliver(radio, frame, reception);
        close(frame, reception, outcome);
    }
    for (const RadioId id : m_frames[index].incidentAt) {
        updateActiveReceptions(m_radios[id]);
        std::erase_if(m_radios[id].incidents, [&](const IncidentSignal& i) { return i.frame == index; });
    }
    const bool ack = m_frames[index].ack;
    const std::uint32_t to = m_frames[index].packet.to;
    m_freeFrames.push_back(index);
    Radio& radio = m_radios[sender];
    radio.sending = false;
    setCurrent(radio, radio.definition.receiveCurrent);
    if (ack) return;
    if (m_settings.csma && to != kBroadcastAddress) {
        radio.state = MacState::AwaitAck;
        schedule(m_now + kAckWaitUs, EventKind::AckTimeout, sender, ++radio.attempt);
    } else {
        finish(sender);
    }
}

} // namespace trundle
