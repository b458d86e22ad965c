// Medium access. Without a protocol a radio sends at once, without listening. CSMA-CA: unslotted, IEEE 802.15.4-2006, 7.5.1.4 and
// 7.5.6; a packet for one address is acknowledged and sent again up to three times, with an interframe space between two packets
// of one sender.
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

/// Starts on the first queued packet if the radio is idle.
void Medium::serve(RadioId id) {
    Radio& radio = m_radios[id];
    if (radio.state != MacState::Rest || radio.queue.empty()) return;
    radio.retries = 0;
    if (m_settings.csma) {
        radio.backoffs = 0;
        radio.exponent = kLeastExponent;
        return backOff(id);
    }
    radio.state = MacState::Send;
    startFrame(id, radio.queue.front(), false);
}

void Medium::backOff(RadioId id) {
    Radio& radio = m_radios[id];
    radio.state = MacState::Backoff;
    const std::uint64_t bits = randomBits(m_settings.seed, radio.place.key, kBackoffSalt, radio.draws++);
    const auto units = static_cast<std::int64_t>(bits >> 32 & ((1u << radio.exponent) - 1));
    schedule(std::max(m_now, radio.restUntil) + units * kBackoffUnitUs, EventKind::ListenStart, id, 0);
}

bool Medium::channelBusy(const Radio& radio) const {
    if (radio.sending || !radio.listening.empty()) return true;
    double power = m_noise;
    for (const IncidentSignal& i : radio.incidents) power += i.milliwatts;
    return 10 * std::log10(power) >= m_settings.carrierSense;
}

void Medium::listenStart(RadioId id) {
    Radio& radio = m_radios[id];
    radio.state = MacState::Listen;
    radio.heardBusy = channelBusy(radio);
    schedule(m_now + kListenUs, EventKind::ListenEnd, id, 0);
}

void Medium::listenEnd(RadioId id) {
    Radio& radio = m_radios[id];
    if (!radio.heardBusy && !channelBusy(radio)) {
        radio.state = MacState::Turnaround;
        return schedule(m_now + kTurnaroundUs, EventKind::SendStart, id, 0);
    }
    radio.exponent = std::min(radio.exponent + 1, kMaxExponent);
    if (++radio.backoffs <= kMaxBackoffs) return backOff(id);
    ++radio.counts.noChannel;
    finish(id);
}

void Medium::sendStart(RadioId id) {
    Radio& radio = m_radios[id];
    if (radio.sending) return backOff(id); // an acknowledgement is being sent
    radio.state = MacState::Send;
    startFrame(id, radio.queue.front(), false);
}

void Medium::ackStart(RadioId id) {
    Radio& radio = m_radios[id];
    if (radio.acks.empty()) return;
    const Outgoing ack = std::move(radio.acks.front());
    radio.acks.pop_front();
    if (!radio.sending && radio.state != MacState::Turnaround) startFrame(id, ack, true);
}

void Medium::acknowledged(RadioId id, const MacFrame& frame) {
    Radio& radio = m_radios[id];
    if (radio.state != MacState::AwaitAck || radio.queue.front().sequence != frame.packet.sequence) return;
    ++radio.counts.acknowledged;
    ++radio.attempt; // invalidates the pending time-out
    finish(id);
}

void Medium::ackTimeout(RadioId id, std::uint32_t attempt) {
    Radio& radio = m_radios[id];
    if (radio.state != MacState::AwaitAck || radio.attempt != attempt) return;
    if (radio.retries < kMaxRetries) {
        ++radio.retries;
        radio.backoffs = 0;
        radio.exponent = kLeastExponent;
        return backOff(id);
    }
    ++radio.counts.noAck;
    finish(id);
}

/// Removes the first packet from the queue, sent or given up, and continues with the next.
void Medium::finish(RadioId id) {
    Radio& radio = m_radios[id];
    const bool isSent = radio.state != MacState::Listen;
    const bool isShort = kFrameOverhead + radio.queue.front().bytes.size() <= kMaxBytesForShortSpace;
    if (isSent) radio.restUntil = m_now + (isShort ? kShortSpaceUs : kLongSpaceUs);
    radio.queue.pop_front();
    radio.state = MacState::Rest;
    serve(id);
}

} // namespace trundle
