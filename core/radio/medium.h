#pragma once
// The shared medium between radios: frames with their airtime, receivers and outcomes. Its clock counts whole microseconds
// between ticks; poses change only at ticks. Everything is a function of (seed, radio paths, poses, packets sent): no wall clock,
// no sequential random stream; simultaneous events are ordered by radio.

#include <deque>
#include <optional>
#include <queue>
#include <span>
#include <unordered_map>

#include "radio/ieee802154.h"
#include "radio/link_budget.h"
#include "radio/neighbours.h"

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

class Medium {
public:
    explicit Medium(const MediumSettings& settings);

    // --- setup ---
    [[nodiscard]] RadioId open(RadioDefinition definition);
    void setWalls(WallCount walls) { m_links.setWalls(std::move(walls)); }

    // --- each tick ---
    /// Sets the pose of the antenna (world frame), valid until the next call.
    void place(RadioId radio, const Pose& antenna);
    /// Processes all events before `until` (us since the start).
    void advance(std::int64_t until);

    // --- for controllers ---
    [[nodiscard]] std::optional<RadioId> find(std::string_view path) const;
    /// Queues a packet, to be sent at the nearest supported power that is not higher (dBm). False: refused.
    bool send(RadioId radio, std::span<const std::uint8_t> bytes, std::uint32_t to, double power);
    /// Takes the oldest packet from the buffer. False if it is empty.
    bool receive(RadioId radio, RadioPacket& packet);
    [[nodiscard]] std::size_t pending(RadioId radio) const { return m_radios[radio].inbox.size(); }
    [[nodiscard]] std::size_t queued(RadioId radio) const { return m_radios[radio].queue.size(); }

    // --- for logs and windows ---
    [[nodiscard]] const MediumSettings& settings() const { return m_settings; }
    [[nodiscard]] std::size_t radioCount() const { return m_radios.size(); }
    [[nodiscard]] const RadioDefinition& radio(RadioId radio) const { return m_radios[radio].definition; }
    [[nodiscard]] const RadioCounts& counts(RadioId radio) const { return m_radios[radio].counts; }
    /// The link at the sender's highest output power.
    [[nodiscard]] LinkBudget link(RadioId from, RadioId to) const;
    /// Data frames at all radios of their channel, by outcome. Frames in the air are not counted yet.
    [[nodiscard]] const std::array<std::uint64_t, kReceptionOutcomes>& outcomes() const { return m_outcomes; }
    /// Number of data frames times the number of other radios on their channel.
    [[nodiscard]] std::uint64_t expected() const { return m_expected; }
    [[nodiscard]] std::uint64_t inTheAir() const { return m_inTheAir; } ///< part of expected() without an outcome yet
    /// A trace that is filled from now on, as long as the caller holds it.
    [[nodiscard]] std::shared_ptr<RadioTrace> trace();

private:
    enum class MacState { Rest, Backoff, Listen, Turnaround, Send, AwaitAck };
    enum class EventKind : std::uint8_t { FrameEnd, AckStart, ListenStart, ListenEnd, SendStart, AckTimeout };
    struct Event {
        std::int64_t at;
        EventKind kind;
        RadioId radio;
        std::uint64_t number; ///< order of creation
        std::uint32_t detail; ///< index of the frame, or the radio's attempt
        bool operator>(const Event& other) const {
            if (at != other.at) return at > other.at;
            const bool end = kind == EventKind::FrameEnd, otherEnd = other.kind == EventKind::FrameEnd;
            if (end != otherEnd) return otherEnd; // a frame that ends now does not disturb one that starts now
            return radio != other.radio ? radio > other.radio : number > other.number;
        }
    };
    struct Outgoing {
        std::vector<std::uint8_t> bytes;
        std::uint32_t to = kBroadcastAddress;
        double power = 0;
        std::uint8_t sequence = 0;
    };
    /// Signal of a frame in the air, as it arrives at a radio.
    struct IncidentSignal {
        std::uint32_t frame;
        double milliwatts;
    };
    struct ActiveReception {
        std::uint32_t frame, reception;
    };
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
        Outgoing packet;
        bool ack = false;
        std::uint64_t number = 0; ///< sequence number among its sender's frames
        double outputPower = 0;
        std::vector<Reception> receptions;
        std::vector<RadioId> incidentAt; ///< radios where it is an incident signal
    };
    struct Radio {
        RadioDefinition definition;
        AntennaPose place;
        RadioCounts counts;
        double powerOffset = 0, readingOffset = 0, clockFactor = 1;
        std::deque<RadioPacket> inbox;
        std::deque<Outgoing> queue;
        std::unordered_map<std::uint32_t, std::uint8_t> lastSequence; ///< by sender's address
        std::vector<IncidentSignal> incidents;
        std::vector<ActiveReception> listening;
        std::uint64_t frames = 0, draws = 0;
        std::uint8_t nextSequence = 0;
        bool sending = false;
        MacState state = MacState::Rest;
        int exponent = kLeastExponent, backoffs = 0, retries = 0;
        std::uint32_t attempt = 0;
        std::int64_t restUntil = 0; ///< end of the interframe space after its last frame, us
        bool heardBusy = false;
        std::deque<Outgoing> acks; ///< waiting to be sent
        std::int64_t energyUntil = 0;
        double current = 0; ///< A
    };

    // medium_mac.cpp
    void schedule(std::int64_t at, EventKind kind, RadioId radio, std::uint32_t detail);
    void handle(const Event& event);
    void serve(RadioId radio);
    void backOff(RadioId radio);
    void listenStart(RadioId radio);
    void listenEnd(RadioId radio);
    void sendStart(RadioId radio);
    void ackStart(RadioId radio);
    void ackTimeout(RadioId radio, std::uint32_t attempt);
    void finish(RadioId radio);
    void acknowledged(RadioId radio, const MacFrame& frame);
    [[nodiscard]] bool channelBusy(const Radio& radio) const;

    // medium_air.cpp
    void startFrame(RadioId radio, const Outgoing& packet, bool ack);
    void endFrame(std::uint32_t frame);
    void arrive(std::uint32_t frame, RadioId radio);
    void abortReception(RadioId radio);
    void updateActiveReceptions(Radio& radio);
    void updateReception(const Radio& radio, const MacFrame& frame, std::uint32_t index, Reception& reception);
    [[nodiscard]] ReceptionOutcome outcomeOf(const MacFrame& frame, const Reception& reception) const;
    [[nodiscard]] ReceptionOutcome deliver(Radio& radio, const MacFrame& frame, const Reception& reception);
    void close(const MacFrame& frame, Reception& reception, ReceptionOutcome outcome);
    void record(const MacFrame& frame, const Reception& reception, ReceptionOutcome outcome);
    [[nodiscard]] double outputPower(const Radio& radio, double wanted) const;
    void setCurrent(Radio& radio, double current);
    [[nodiscard]] double sendCurrent(const Radio& radio, double power) const;
    template <class Do> void forTraces(const Do& with);

    MediumSettings m_settings;
    LinkModel m_links;
    Neighbours m_neighbours;
    std::vector<Radio> m_radios;
    std::unordered_map<std::string, RadioId> m_byPath; // iteration order is never used
    std::vector<std::uint32_t> m_onChannel;            ///< number of radios by channel
    std::vector<MacFrame> m_frames;                    ///< in the air; slots are reused
    std::vector<std::uint32_t> m_freeFrames;
    std::priority_queue<Event, std::vector<Event>, std::greater<>> m_events;
    std::int64_t m_now = 0; ///< us
    std::uint64_t m_eventNumber = 0;
    double m_bestGain = 0, m_leastPower = 1e9; ///< over all radios
    double m_noise = 0;                        ///< mW
    std::array<std::uint64_t, kReceptionOutcomes> m_outcomes{};
    std::uint64_t m_expected = 0, m_inTheAir = 0;
    std::vector<RadioId> m_near; ///< scratch buffer
    std::vector<std::weak_ptr<RadioTrace>> m_traces;
};

} // namespace trundle
