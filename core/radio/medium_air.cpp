// Frames in the air. Needs: who sends, where everybody stands. Assumptions: places and gains hold for the whole of a frame; a frame reaches
// all at once (300 m are one microsecond); what is 10 dB below the noise disturbs nobody. A receiver that may be disturbed holds on to the
// first frame it can hear; from then on each stretch of time with the same others in the air counts by its own signal to noise ratio.
#include <algorithm>
#include <cmath>

#include "base/rng.h"
#include "radio/medium.h"
#include "radio/radio_figures.h"

namespace trundle {

namespace {

constexpr double kNegligible = 10; ///< dB below the noise
constexpr double kAlone = 1e9;     ///< dB over nothing

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
    Frame& frame = m_frames[index];
    frame = {sender, m_now, 0, packet, ack, radio.frames++, outputPower(radio, packet.power), {}, {}};
    const auto mpdu = ack ? kAckBytes : static_cast<std::uint32_t>(packet.bytes.size()) + kFrameOverhead;
    frame.end = m_now + airtimeUs(mpdu, radio.definition.bitRate);
    deafen(sender);
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
        if ((m_radios[other].place.pose.position - place).squaredNorm() > range * range) continue; // the grid is coarse
        ++heard;
        if (!ack) ++m_expected, ++m_inTheAir;
        arrive(index, other);
    }
    if (ack) return;
    const std::uint64_t far = m_onChannel[channel] - 1 - heard;
    m_expected += far;
    m_fates[static_cast<std::size_t>(Fate::TooWeak)] += far;
}

/// The frame's first bit at a radio.
void Medium::arrive(std::uint32_t index, RadioId id) {
    Frame& frame = m_frames[index];
    Radio& radio = m_radios[id];
    Reception reception{id, m_links.between(m_radios[frame.from].place, radio.place, frame.outputPower)};
    reception.since = m_now;
    if (m_settings.collisions || m_settings.csma) {
        settleListening(radio);
        radio.incidents.push_back({index, std::pow(10, reception.link.power / 10)});
        frame.heardBy.push_back(id);
    }
    frame.receptions.push_back(reception);
    Reception& mine = frame.receptions.back();
    if (mine.link.power < radio.definition.minReceivePower) close(frame, mine, Fate::TooWeak);
    else if (radio.sending || radio.turn == Turn::Turnaround) close(frame, mine, Fate::Sending);
    else if (m_settings.collisions && !radio.listening.empty()) close(frame, mine, Fate::Busy);
    else radio.listening.push_back({index, static_cast<std::uint32_t>(frame.receptions.size() - 1)});
}

/// A radio that sends hears nothing.
void Medium::deafen(RadioId id) {
    Radio& radio = m_radios[id];
    settleListening(radio);
    for (const Listening& l : radio.listening) close(m_frames[l.frame], m_frames[l.frame].receptions[l.reception], Fate::Sending);
    radio.listening.clear();
}

/// To be called before what is in the air at a radio changes.
void Medium::settleListening(Radio& radio) {
    for (const Listening& l : radio.listening)
        settle(radio, m_frames[l.frame], l.frame, m_frames[l.frame].receptions[l.reception]);
}

void Medium::settle(const Radio& radio, const Frame& frame, std::uint32_t index, Reception& reception) {
    if (m_now == reception.since) return;
    double others = 0;
    if (m_settings.collisions)
        for (const Incident& i : radio.incidents)
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

Fate Medium::judge(const Frame& frame, const Reception& reception) const {
    if (m_settings.packetErrors) {
        const std::uint64_t a = m_radios[frame.from].place.key, b = m_radios[reception.radio].place.key;
        const std::uint64_t pair = randomBits(std::min(a, b), std::max(a, b), 0, 0);
        const double chance = toUnit(randomBits(m_settings.seed, pair, frame.number, a));
        if (chance < reception.success) return Fate::Delivered;
        const double bits = 8.0 * (frame.ack ? kAckBytes : static_cast<double>(frame.packet.bytes.size()) + kFrameOverhead);
        const double alone = reception.link.power - m_settings.noiseFloor - m_settings.implementationLoss;
        return chance < receptionRate(alone, bits) ? Fate::Collision : Fate::BitErrors;
    }
    return m_settings.collisions && reception.worstSir < m_settings.captureMargin ? Fate::Collision : Fate::Delivered;
}

/// Whole and without an error.
Fate Medium::deliver(Radio& radio, const Frame& frame, const Reception& reception) {
    const std::uint32_t mine = radio.definition.address, to = frame.packet.to;
    if (to != kBroadcastAddress && to != mine) return Fate::NotForIt;
    if (frame.ack) {
        acknowledged(radio.place.id, frame);
        return Fate::Delivered;
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
            return Fate::Duplicate;
        }
    }
    if (radio.inbox.size() >= radio.definition.bufferLimit) {
        ++radio.counts.dropped;
        return Fate::BufferFull;
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
    return Fate::Delivered;
}

void Medium::close(const Frame& frame, Reception& reception, Fate fate) {
    reception.open = false;
    if (!frame.ack) {
        ++m_fates[static_cast<std::size_t>(fate)];
        --m_inTheAir;
    }
    if (!m_traces.empty()) record(frame, reception, fate);
}

void Medium::record(const Frame& frame, const Reception& reception, Fate fate) {
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
                        fate};
    forTraces([&](RadioTrace& trace) { trace.records.push_back(r); });
}

void Medium::endFrame(std::uint32_t index) {
    const RadioId sender = m_frames[index].from;
    for (std::size_t i = 0; i < m_frames[index].receptions.size(); ++i) {
        Frame& frame = m_frames[index];
        Reception& reception = frame.receptions[i];
        if (!reception.open) continue;
        Radio& radio = m_radios[reception.radio];
        settle(radio, frame, index, reception);
        std::erase_if(radio.listening, [&](const Listening& l) { return l.frame == index; });
        Fate fate = judge(frame, reception);
        if (fate == Fate::Delivered) fate = deliver(radio, frame, reception);
        close(frame, reception, fate);
    }
    for (const RadioId id : m_frames[index].heardBy) {
        settleListening(m_radios[id]);
        std::erase_if(m_radios[id].incidents, [&](const Incident& i) { return i.frame == index; });
    }
    const bool ack = m_frames[index].ack;
    const std::uint32_t to = m_frames[index].packet.to;
    m_freeFrames.push_back(index);
    Radio& radio = m_radios[sender];
    radio.sending = false;
    setCurrent(radio, radio.definition.receiveCurrent);
    if (ack) return;
    if (m_settings.csma && to != kBroadcastAddress) {
        radio.turn = Turn::AwaitAck;
        schedule(m_now + kAckWaitUs, EventKind::AckTimeout, sender, ++radio.attempt);
    } else {
        finish(sender);
    }
}

} // namespace trundle
