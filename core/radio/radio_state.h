#pragma once
// What the medium knows of each radio, of the frames in the air, and what is to happen.

#include <algorithm>
#include <deque>
#include <queue>
#include <unordered_map>

#include "radio/ieee802154.h"
#include "radio/link_budget.h"

namespace trundle {

struct RadioPacket {
    double time = 0; ///< s, arrival of its last bit, by the receiver's clock
    double rssi = 0; ///< dBm as the receiver reads it: with its resolution, offset and upper limit
    int lqi = 0;
    std::uint32_t from = 0, to = 0; ///< addresses
    std::uint8_t sequence = 0;
    std::vector<std::uint8_t> bytes;
};

/// Counters of one radio since the start.
struct RadioCounts {
    std::uint64_t sent = 0;      ///< data frames sent, including retransmissions
    std::uint64_t refused = 0;   ///< too long, or the queue was full
    std::uint64_t noChannel = 0; ///< given up: the channel was never clear
    std::uint64_t noAck = 0;     ///< given up: no acknowledgement arrived
    std::uint64_t acknowledged = 0;
    std::uint64_t received = 0;
    std::uint64_t dropped = 0; ///< received packets dropped because the buffer was full
    double lastRssi = 0;       ///< dBm, of the last packet received; 0 before the first
    int lastLqi = 0;
    double energy = 0; ///< J
};

enum class MacState { Rest, Backoff, Listen, Turnaround, Send, AwaitAck };

struct OutgoingPacket {
    std::vector<std::uint8_t> bytes;
    std::uint32_t to = kBroadcastAddress;
    double power = 0;
    std::uint8_t sequence = 0;
    std::uint64_t number = 0; ///< among its sender's packets; its last eight bits are the sequence number
};

/// Signal of a frame in the air, as it arrives at a radio.
struct IncidentSignal {
    std::uint32_t frame;
    double milliwatts;
};

/// A frame that a radio receives, and which of the frame's receptions that is.
struct ActiveReception {
    std::uint32_t frame, reception;
};

/// A frame at one radio of its channel.
struct Reception {
    RadioId radio;
    LinkBudget link;
    double success = 1;
    double worstSinr = 1e9, worstSir = 1e9; ///< dB over noise and interference, and over interference alone
    std::int64_t since = 0;                 ///< `success` is computed up to this time, us
    bool open = true;
};

struct MacFrame {
    RadioId from = kNoRadio;
    std::int64_t start = 0, end = 0;
    OutgoingPacket packet;
    bool ack = false;
    std::uint64_t number = 0; ///< sequence number among its sender's frames
    double outputPower = 0;
    std::vector<Reception> receptions;
    std::vector<RadioId> incidentAt; ///< radios where it is an incident signal
};

struct RadioState {
    RadioDefinition definition;
    AntennaPose place;
    RadioCounts counts;
    double powerOffset = 0, readingOffset = 0, clockFactor = 1;
    std::deque<RadioPacket> inbox;
    std::deque<OutgoingPacket> queue;

    // of PhysicalLayer
    std::unordered_map<RadioId, std::uint64_t> lastPacket; ///< by sender: number of the last one for it that it received
    std::vector<IncidentSignal> incidents;
    std::vector<ActiveReception> listening;
    std::uint64_t frames = 0;
    bool sending = false;
    std::int64_t energyUntil = 0;
    double current = 0; ///< A

    // of MediumAccess
    std::uint64_t draws = 0;
    std::uint64_t packets = 0; ///< queued since the start
    MacState state = MacState::Rest;
    int exponent = kLeastExponent, backoffs = 0, retries = 0;
    std::uint32_t attempt = 0;
    std::int64_t restUntil = 0; ///< end of the interframe space after its last frame, us
    bool heardBusy = false;
    std::deque<OutgoingPacket> acks; ///< waiting to be sent
};

enum class RadioEventKind : std::uint8_t { FrameEnd, AckStart, ListenStart, ListenEnd, SendStart, AckTimeout };

struct RadioEvent {
    std::int64_t at; ///< us
    RadioEventKind kind;
    RadioId radio;
    std::uint64_t number; ///< order of creation
    std::uint32_t detail; ///< index of the frame, or the radio's attempt
    bool operator>(const RadioEvent& other) const {
        if (at != other.at) return at > other.at;
        const bool end = kind == RadioEventKind::FrameEnd, otherEnd = other.kind == RadioEventKind::FrameEnd;
        if (end != otherEnd) return otherEnd; // a frame that ends now does not disturb one that starts now
        return radio != other.radio ? radio > other.radio : number > other.number;
    }
};

/// What is to happen, and the time: that of the last event taken, in whole microseconds.
class RadioEvents {
public:
    [[nodiscard]] std::int64_t now() const { return m_now; }
    void schedule(std::int64_t at, RadioEventKind kind, RadioId radio, std::uint32_t detail) {
        m_events.push({at, kind, radio, m_count++, detail});
    }
    /// The next one before `until`. Without one the time becomes `until`.
    [[nodiscard]] bool take(std::int64_t until, RadioEvent& event) {
        if (m_events.empty() || m_events.top().at >= until) {
            m_now = std::max(m_now, until);
            return false;
        }
        event = m_events.top();
        m_events.pop();
        m_now = event.at;
        return true;
    }

private:
    std::priority_queue<RadioEvent, std::vector<RadioEvent>, std::greater<>> m_events;
    std::int64_t m_now = 0;
    std::uint64_t m_count = 0;
};

} // namespace trundle
