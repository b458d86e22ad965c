#include "radio/medium_access.h"

#include <algorithm>

#include "base/rng.h"

namespace trundle {

namespace {

constexpr std::uint64_t kBackoffSalt = 0x4241434b;

} // namespace

void MediumAccess::handle(const RadioEvent& event) {
    switch (event.kind) {
    case RadioEventKind::FrameEnd: return frameEnd(event.detail);
    case RadioEventKind::AckStart: return ackStart(event.radio);
    case RadioEventKind::ListenStart: return listenStart(event.radio);
    case RadioEventKind::ListenEnd: return listenEnd(event.radio);
    case RadioEventKind::SendStart: return sendStart(event.radio);
    case RadioEventKind::AckTimeout: return ackTimeout(event.radio, event.detail);
    }
}

void MediumAccess::serve(RadioId id) {
    RadioState& radio = m_radios[id];
    if (radio.state != MacState::Rest || radio.queue.empty()) return;
    radio.retries = 0;
    if (m_settings.csma) {
        radio.backoffs = 0;
        radio.exponent = kLeastExponent;
        return backOff(id);
    }
    radio.state = MacState::Send;
    m_layer.startFrame(id, radio.queue.front(), false);
}

void MediumAccess::backOff(RadioId id) {
    RadioState& radio = m_radios[id];
    radio.state = MacState::Backoff;
    const std::uint64_t bits = randomBits(m_settings.seed, radio.place.key, kBackoffSalt, radio.draws++);
    const auto units = static_cast<std::int64_t>(bits >> 32 & ((1u << radio.exponent) - 1));
    m_events.schedule(std::max(m_events.now(), radio.restUntil) + units * kBackoffUnitUs, RadioEventKind::ListenStart, id, 0);
}

void MediumAccess::listenStart(RadioId id) {
    RadioState& radio = m_radios[id];
    radio.state = MacState::Listen;
    radio.heardBusy = m_layer.channelBusy(radio);
    m_events.schedule(m_events.now() + kListenUs, RadioEventKind::ListenEnd, id, 0);
}

void MediumAccess::listenEnd(RadioId id) {
    RadioState& radio = m_radios[id];
    if (!radio.heardBusy && !m_layer.channelBusy(radio)) {
        radio.state = MacState::Turnaround;
        return m_events.schedule(m_events.now() + kTurnaroundUs, RadioEventKind::SendStart, id, 0);
    }
    radio.exponent = std::min(radio.exponent + 1, kMaxExponent);
    if (++radio.backoffs <= kMaxBackoffs) return backOff(id);
    ++radio.counts.noChannel;
    finish(id);
}

void MediumAccess::sendStart(RadioId id) {
    RadioState& radio = m_radios[id];
    if (radio.sending) return backOff(id); // an acknowledgement is being sent
    radio.state = MacState::Send;
    m_layer.startFrame(id, radio.queue.front(), false);
}

void MediumAccess::ackStart(RadioId id) {
    RadioState& radio = m_radios[id];
    if (radio.acks.empty()) return;
    const OutgoingPacket ack = std::move(radio.acks.front());
    radio.acks.pop_front();
    if (!radio.sending && radio.state != MacState::Turnaround) m_layer.startFrame(id, ack, true);
}

void MediumAccess::frameEnd(std::uint32_t frame) {
    const EndedFrame ended = m_layer.endFrame(frame);
    for (const RadioId radio : ended.acknowledged) acknowledged(radio, ended.sequence);
    if (ended.ack) return;
    if (m_settings.csma && ended.to != kBroadcastAddress) {
        RadioState& radio = m_radios[ended.from];
        radio.state = MacState::AwaitAck;
        m_events.schedule(m_events.now() + kAckWaitUs, RadioEventKind::AckTimeout, ended.from, ++radio.attempt);
    } else {
        finish(ended.from);
    }
}

void MediumAccess::acknowledged(RadioId id, std::uint8_t sequence) {
    RadioState& radio = m_radios[id];
    if (radio.state != MacState::AwaitAck || radio.queue.front().sequence != sequence) return;
    ++radio.counts.acknowledged;
    ++radio.attempt; // invalidates the pending time-out
    finish(id);
}

void MediumAccess::ackTimeout(RadioId id, std::uint32_t attempt) {
    RadioState& radio = m_radios[id];
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
void MediumAccess::finish(RadioId id) {
    RadioState& radio = m_radios[id];
    const bool isSent = radio.state != MacState::Listen;
    const bool isShort = kFrameOverhead + radio.queue.front().bytes.size() <= kMaxBytesForShortSpace;
    if (isSent) radio.restUntil = m_events.now() + (isShort ? kShortSpaceUs : kLongSpaceUs);
    radio.queue.pop_front();
    radio.state = MacState::Rest;
    serve(id);
}

} // namespace trundle
