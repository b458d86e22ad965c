#pragma once
// Transmission and reception of frames. Needs: sender, poses of all radios. Assumptions: poses and gains are constant during a
// frame; a frame reaches all receivers at once (300 m are one microsecond); signals 10 dB below the noise are ignored. With
// collisions a receiver locks on to the first frame that it can decode; each interval with the same interfering frames then
// counts by its own signal-to-noise ratio.

#include <array>
#include <memory>

#include "radio/neighbours.h"
#include "radio/radio_state.h"

namespace trundle {

/// A frame whose last bit has been sent.
struct EndedFrame {
    RadioId from = kNoRadio;
    bool ack = false;
    std::uint32_t to = kBroadcastAddress;
    std::uint8_t sequence = 0;
    std::vector<RadioId> acknowledged; ///< of an acknowledgement: radios that received it
};

class PhysicalLayer {
public:
    /// All of these outlive this.
    PhysicalLayer(const MediumSettings& settings, std::vector<RadioState>& radios, RadioEvents& events);

    void setWalls(WallCount walls) { m_links.setWalls(std::move(walls)); }
    /// A radio that is in the list since now.
    void add(RadioState& radio);
    void place(RadioState& radio, const Pose& antenna);

    /// A packet, or an acknowledgement, goes into the air; its end is an event.
    void startFrame(RadioId radio, const OutgoingPacket& packet, bool ack);
    EndedFrame endFrame(std::uint32_t frame);
    [[nodiscard]] bool channelBusy(const RadioState& radio) const;
    /// Adds the energy that all radios have used up to now.
    void countEnergy();

    /// The link at the sender's highest output power.
    [[nodiscard]] LinkBudget link(const RadioState& from, const RadioState& to) const;
    [[nodiscard]] const std::array<std::uint64_t, kReceptionOutcomes>& outcomes() const { return m_outcomes; }
    [[nodiscard]] std::uint64_t expected() const { return m_expected; }
    [[nodiscard]] std::uint64_t inTheAir() const { return m_inTheAir; }
    [[nodiscard]] std::shared_ptr<RadioTrace> trace();

private:
    [[nodiscard]] std::uint32_t freeFrame();
    void arriveEverywhere(std::uint32_t frame);
    void arrive(std::uint32_t frame, RadioId radio);
    void abortReception(RadioId radio);
    [[nodiscard]] bool replaceWeaker(RadioState& radio, const Reception& reception);
    void updateActiveReceptions(RadioState& radio);
    void updateReception(const RadioState& radio, const MacFrame& frame, std::uint32_t index, Reception& reception);
    [[nodiscard]] ReceptionOutcome outcomeOf(const MacFrame& frame, const Reception& reception) const;
    [[nodiscard]] ReceptionOutcome deliver(RadioState& radio, const MacFrame& frame, const Reception& reception,
                                           EndedFrame& ended);
    void answer(RadioState& radio, const MacFrame& frame);
    void close(const MacFrame& frame, Reception& reception, ReceptionOutcome outcome);
    void record(const MacFrame& frame, const Reception& reception, ReceptionOutcome outcome);
    [[nodiscard]] static double outputPower(const RadioState& radio, double wanted);
    void setCurrent(RadioState& radio, double current);
    template <class Do> void forTraces(const Do& with);

    const MediumSettings& m_settings;
    std::vector<RadioState>& m_radios;
    RadioEvents& m_events;
    LinkModel m_links;
    Neighbours m_neighbours;
    std::vector<std::uint32_t> m_onChannel; ///< number of radios by channel
    std::vector<MacFrame> m_frames;         ///< in the air; slots are reused
    std::vector<std::uint32_t> m_freeFrames;
    double m_bestGain = 0, m_leastPower = 1e9; ///< over all radios
    double m_noise = 0;                        ///< mW
    std::array<std::uint64_t, kReceptionOutcomes> m_outcomes{};
    std::uint64_t m_expected = 0, m_inTheAir = 0;
    std::vector<RadioId> m_near; ///< scratch buffer
    std::vector<std::weak_ptr<RadioTrace>> m_traces;
};

} // namespace trundle
