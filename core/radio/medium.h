#pragma once
// The shared medium between radios: frames with their airtime, receivers and outcomes. Its clock counts whole microseconds
// between ticks; poses change only at ticks. Everything is a function of (seed, radio paths, poses, packets sent): no wall clock,
// no sequential random stream; simultaneous events are ordered by radio.

#include <optional>
#include <set>
#include <span>
#include <string>
#include <unordered_map>

#include "radio/medium_access.h"

namespace trundle {

class Medium {
public:
    explicit Medium(const MediumSettings& settings);
    Medium(const Medium&) = delete;
    Medium& operator=(const Medium&) = delete;

    // --- setup ---
    [[nodiscard]] RadioId open(RadioDefinition definition);
    /// Keeps an address for a radio that is opened later and asks for it: one without an address gets another.
    void reserve(std::uint32_t address) { m_reserved.insert(address); }
    void setWalls(WallCount walls) { m_layer.setWalls(std::move(walls)); }

    // --- each tick ---
    /// Sets the pose of the antenna (world frame), valid until the next call.
    void place(RadioId radio, const Pose& antenna) { m_layer.place(m_radios[radio], antenna); }
    /// Processes all events before `until` (us since the start).
    void advance(std::int64_t until);

    /// It has no power any more: it takes no packets to be sent, and receives nothing. What it has queued is still sent.
    void switchOff(RadioId radio);

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
    [[nodiscard]] LinkBudget link(RadioId from, RadioId to) const { return m_layer.link(m_radios[from], m_radios[to]); }
    /// Data frames at all radios of their channel, by outcome. Frames in the air are not counted yet.
    [[nodiscard]] const std::array<std::uint64_t, kReceptionOutcomes>& outcomes() const { return m_layer.outcomes(); }
    /// Number of data frames times the number of other radios on their channel.
    [[nodiscard]] std::uint64_t expected() const { return m_layer.expected(); }
    [[nodiscard]] std::uint64_t inTheAir() const { return m_layer.inTheAir(); } ///< part of expected() without an outcome yet
    /// A trace that is filled from now on, as long as the caller holds it.
    [[nodiscard]] std::shared_ptr<RadioTrace> trace() { return m_layer.trace(); }

private:
    MediumSettings m_settings;
    std::vector<RadioState> m_radios;
    std::unordered_map<std::string, RadioId> m_byPath; // iteration order is never used
    std::set<std::uint32_t> m_reserved;                // addresses
    RadioEvents m_events;
    PhysicalLayer m_layer;
    MediumAccess m_access;
};

} // namespace trundle
