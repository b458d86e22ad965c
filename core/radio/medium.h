#pragma once
// The air between radios: frames with their time on it, who hears them and what becomes of them. Its clock runs in whole microseconds
// between the ticks; places are held from tick to tick. Everything is a function of (seed, radios' paths, places, what is sent): no wall
// clock, no running stream of random numbers, ties in the order of the radios.

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
    double time = 0; ///< s, its last bit, by the receiver's clock
    double rssi = 0; ///< dBm as read: with the radio's step, offset and upper end
    int lqi = 0;
    std::uint32_t from = 0, to = 0; ///< addresses
    std::uint8_t sequence = 0;
    std::vector<std::uint8_t> bytes;
};

/// What one radio did so far.
struct RadioCounts {
    std::uint64_t sent = 0;      ///< frames with data that went out, repetitions included
    std::uint64_t refused = 0;   ///< too long, or the queue was full
    std::uint64_t noChannel = 0; ///< given up: the channel was never clear
    std::uint64_t noAck = 0;     ///< given up: nobody acknowledged
    std::uint64_t acknowledged = 0;
    std::uint64_t received = 0;
    std::uint64_t dropped = 0; ///< newest, for a full buffer
    double lastRssi = 0;       ///< dBm, of the last packet received; 0 before
    int lastLqi = 0;
    double energy = 0; ///< J
};

class Medium {
public:
    explicit Medium(const MediumSettings& settings);

    // --- building ---
    [[nodiscard]] RadioId open(RadioDefinition definition);
    void setWalls(WallCount walls) { m_links.setWalls(std::move(walls)); }

    // --- the tick ---
    /// Where the antenna stands until it is put elsewhere.
    void place(RadioId radio, const Pose& antenna);
    /// Everything that happens before `until` (us since the start).
    void advance(std::int64_t until);

    // --- what a controller does ---
    [[nodiscard]] std::optional<RadioId> find(std::string_view path) const;
    /// Queues a packet, to go out at the nearest power that the radio can and that is not more. False: refused.
    bool send(RadioId radio, std::span<const std::uint8_t> bytes, std::uint32_t to, double power);
    /// The oldest packet in the buffer.
    bool receive(RadioId radio, RadioPacket& packet);
    [[nodiscard]] std::size_t pending(RadioId radio) const { return m_radios[radio].inbox.size(); }
    [[nodiscard]] std::size_t queued(RadioId radio) const { return m_radios[radio].queue.size(); }

    // --- what others read ---
    [[nodiscard]] const MediumSettings& settings() const { return m_settings; }
    [[nodiscard]] std::size_t radioCount() const { return m_radios.size(); }
    [[nodiscard]] const RadioDefinition& radio(RadioId radio) const { return m_radios[radio].definition; }
    [[nodiscard]] const RadioCounts& counts(RadioId radio) const { return m_radios[radio].counts; }
    [[nodiscard]] const Pose& antennaPose(RadioId radio) const { return m_radios[radio].place.pose; }
    /// At what the sender can give at most.
    [[nodiscard]] LinkBudget link(RadioId from, RadioId to) const;
    /// Frames with data at all radios of their channel, by fate. What is in the air is in none.
    [[nodiscard]] const std::array<std::uint64_t, kFates>& fates() const { return m_fates; }
    /// Frames with data times the radios that could have heard them.
    [[nodiscard]] std::uint64_t expected() const { return m_expected; }
    [[nodiscard]] std::uint64_t inTheAir() const { return m_inTheAir; } ///< of expected(), not decided yet
    /// Fills from now on, for as long as somebody holds it.
    [[nodiscard]] std::shared_ptr<RadioTrace> trace();

private:
    enum class Turn { Rest, Backoff, Listen, Turnaround, Send, AwaitAck };
    enum class EventKind : std::uint8_t { FrameEnd, AckStart, ListenStart, ListenEnd, SendStart, AckTimeout };
    struct Event {
        std::int64_t at;
        EventKind kind;
        RadioId radio;
        std::uint64_t number; ///< order of making
        std::uint32_t detail; ///< frame, or the radio's attempt
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
    /// A frame in the air at a radio.
    struct Incident {
        std::uint32_t frame;
        double milliwatts;
    };
    struct Listening {
        std::uint32_t frame, reception;
    };
    struct Reception {
        RadioId radio;
        LinkBudget link;
        double success = 1;
        double worstSinr = 1e9, worstSir = 1e9; ///< dB over noise and others, over others alone
        std::int64_t since = 0;                 ///< up to here `success` is known
        bool open = true;
    };
    struct Frame {
        RadioId from = kNoRadio;
        std::int64_t start = 0, end = 0;
        Outgoing packet;
        bool ack = false;
        std::uint64_t number = 0; ///< of its sender's frames
        double outputPower = 0;
        std::vector<Reception> receptions;
        std::vector<RadioId> heardBy; ///< radios with an incident of it
    };
    struct Radio {
        RadioDefinition definition;
        AntennaPlace place;
        RadioCounts counts;
        double powerOffset = 0, readingOffset = 0, clockFactor = 1;
        std::deque<RadioPacket> inbox;
        std::deque<Outgoing> queue;
        std::unordered_map<std::uint32_t, std::uint8_t> lastSequence; ///< by sender's address
        std::vector<Incident> incidents;
        std::vector<Listening> listening;
        std::uint64_t frames = 0, draws = 0;
        std::uint8_t nextSequence = 0;
        bool sending = false;
        Turn turn = Turn::Rest;
        int exponent = kLeastExponent, backoffs = 0, retries = 0;
        std::uint32_t attempt = 0;
        std::int64_t restUntil = 0; ///< the space behind its last frame ends
        bool heardBusy = false;
        std::deque<Outgoing> acks; ///< to be sent
        std::int64_t energyUntil = 0;
        double current = 0; ///< A, at present
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
    void acknowledged(RadioId radio, const Frame& frame);
    [[nodiscard]] bool channelBusy(const Radio& radio) const;

    // medium_air.cpp
    void startFrame(RadioId radio, const Outgoing& packet, bool ack);
    void endFrame(std::uint32_t frame);
    void arrive(std::uint32_t frame, RadioId radio);
    void deafen(RadioId radio);
    void settleListening(Radio& radio);
    void settle(const Radio& radio, const Frame& frame, std::uint32_t index, Reception& reception);
    [[nodiscard]] Fate judge(const Frame& frame, const Reception& reception) const;
    [[nodiscard]] Fate deliver(Radio& radio, const Frame& frame, const Reception& reception);
    void close(const Frame& frame, Reception& reception, Fate fate);
    void record(const Frame& frame, const Reception& reception, Fate fate);
    [[nodiscard]] double outputPower(const Radio& radio, double wanted) const;
    void setCurrent(Radio& radio, double current);
    [[nodiscard]] double sendCurrent(const Radio& radio, double power) const;
    template <class Do> void forTraces(const Do& with);

    MediumSettings m_settings;
    LinkModel m_links;
    Neighbours m_neighbours;
    std::vector<Radio> m_radios;
    std::unordered_map<std::string, RadioId> m_byPath; // looked up, never walked
    std::vector<std::uint32_t> m_onChannel;            ///< radios by channel
    std::vector<Frame> m_frames;                       ///< in the air; reused
    std::vector<std::uint32_t> m_freeFrames;
    std::priority_queue<Event, std::vector<Event>, std::greater<>> m_events;
    std::int64_t m_now = 0; ///< us
    std::uint64_t m_eventNumber = 0;
    double m_bestGain = 0, m_leastPower = 1e9; ///< of all radios
    double m_noise = 0;                        ///< mW
    std::array<std::uint64_t, kFates> m_fates{};
    std::uint64_t m_expected = 0, m_inTheAir = 0;
    std::vector<RadioId> m_near; ///< scratch
    std::vector<std::weak_ptr<RadioTrace>> m_traces;
};

} // namespace trundle
