// Who may send when. Without a protocol a radio sends at once and asks nobody. CSMA-CA: unslotted, IEEE 802.15.4-2006, 7.5.1.4 and 7.5.6;
// a packet for one address is acknowledged and repeated up to three times, and between two packets of one sender is a space.
#include <algorithm>
#include <cmath>

#include "base/rng.h"
#include "radio/medium.h"

namespace trundle {

namespace {

constexpr std::uint64_t kBackoffSalt = 0x4241434b;

} // namespace

void Medium::schedule(std::int64_t at, EventKind kind, RadioId radio, std::uint32_t detail) {
    m_events.push({at, kind, radio, m_eventNumber++, detail});
}

void Medium::handle(const Event& event) {
    switch (event.kind) {
    case EventKind::FrameEnd: return endFrame(event.detail);
    case EventKind::AckStart: return ackStart(event.radio);
    case EventKind::ListenStart: return listenStart(event.radio);
    case EventKind::ListenEnd: return listenEnd(event.radio);
    case EventKind::SendStart: return sendStart(event.radio);
    case EventKind::AckTimeout: return ackTimeout(event.radio, event.detail);
    }
}

/// Begins with the first packet that waits, where nothing is under way.
void Medium::serve(RadioId id) {
    Radio& radio = m_radios[id];
    if (radio.turn != Turn::Rest || radio.queue.empty()) return;
    radio.retries = 0;
    if (m_settings.csma) {
        radio.backoffs = 0;
        radio.exponent = kLeastExponent;
        return backOff(id);
    }
    radio.turn = Turn::Send;
    startFrame(id, radio.queue.front(), false);
}

void Medium::backOff(RadioId id) {
    Radio& radio = m_radios[id];
    radio.turn = Turn::Backoff;
    const std::uint64_t bits = randomBits(m_settings.seed, radio.place.key, kBackoffSalt, radio.draws++);
    const auto units = static_cast<std::int64_t>(bits >> 32 & ((1u << radio.exponent) - 1));
    schedule(std::max(m_now, radio.restUntil) + units * kBackoffUnitUs, EventKind::ListenStart, id, 0);
}

bool Medium::channelBusy(const Radio& radio) const {
    if (radio.sending || !radio.listening.empty()) return true;
    double power = m_noise;
    for (const Incident& i : radio.incidents) power += i.milliwatts;
    return 10 * std::log10(power) >= m_settings.carrierSense;
}

void Medium::listenStart(RadioId id) {
    Radio& radio = m_radios[id];
    radio.turn = Turn::Listen;
    radio.heardBusy = channelBusy(radio);
    schedule(m_now + kListenUs, EventKind::ListenEnd, id, 0);
}

void Medium::listenEnd(RadioId id) {
    Radio& radio = m_radios[id];
    if (!radio.heardBusy && !channelBusy(radio)) {
        radio.turn = Turn::Turnaround;
        return schedule(m_now + kTurnaroundUs, EventKind::SendStart, id, 0);
    }
    radio.exponent = std::min(radio.exponent + 1, kMostExponent);
    if (++radio.backoffs <= kMostBackoffs) return backOff(id);
    ++radio.counts.noChannel;
    finish(id);
}

void Medium::sendStart(RadioId id) {
    Radio& radio = m_radios[id];
    if (radio.sending) return backOff(id); // an acknowledgement went first
    radio.turn = Turn::Send;
    startFrame(id, radio.queue.front(), false);
}

void Medium::ackStart(RadioId id) {
    Radio& radio = m_radios[id];
    if (radio.acks.empty()) return;
    const Outgoing ack = std::move(radio.acks.front());
    radio.acks.pop_front();
    if (!radio.sending && radio.turn != Turn::Turnaround) startFrame(id, ack, true);
}

void Medium::acknowledged(RadioId id, const Frame& frame) {
    Radio& radio = m_radios[id];
    if (radio.turn != Turn::AwaitAck || radio.queue.front().sequence != frame.packet.sequence) return;
    ++radio.counts.acknowledged;
    ++radio.attempt; // the time-out that waits is for nothing
    finish(id);
}

void Medium::ackTimeout(RadioId id, std::uint32_t attempt) {
    Radio& radio = m_radios[id];
    if (radio.turn != Turn::AwaitAck || radio.attempt != attempt) return;
    if (radio.retries < kMostRetries) {
        ++radio.retries;
        radio.backoffs = 0;
        radio.exponent = kLeastExponent;
        return backOff(id);
    }
    ++radio.counts.noAck;
    finish(id);
}

/// Done with the first packet, one way or the other.
void Medium::finish(RadioId id) {
    Radio& radio = m_radios[id];
    const bool isSent = radio.turn != Turn::Listen;
    const bool isShort = kFrameOverhead + radio.queue.front().bytes.size() <= kMostBytesForShortSpace;
    if (isSent) radio.restUntil = m_now + (isShort ? kShortSpaceUs : kLongSpaceUs);
    radio.queue.pop_front();
    radio.turn = Turn::Rest;
    serve(id);
}

} // namespace trundle
