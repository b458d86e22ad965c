#pragma once
// Radios at places of one's choosing, without a run: what a link comes to, term by term, as a frame in a run would find it. For windows and
// maps. scene/radio_model.h finds the radios of an experiment and what stands between them.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "radio/link_budget.h"
#include "radio/radio_figures.h"

namespace trundle {

/// A radio of an experiment and where its antenna sits.
struct RadioNode {
    RadioDefinition radio; ///< path "robot0/radio", antenna, figures; its address as written, 0 where the run gives it one
    std::string robot;
    std::size_t body = 0; ///< which of the experiment's bodies carries it, as in BodyPoses
    Pose mounting;        ///< of the antenna in that body; it looks along +x, its up is +z
};

/// One link, dBm and dB.
struct LinkReport {
    double outputPower = 0; ///< leaves the sender: the nearest level that it has, with its offset
    LinkBudget link;        ///< link.power = outputPower + sendGain + receiveGain - pathLoss - shadow - wallLoss
    double rssi = 0;        ///< as the receiver reads it
    double snr = 0;         ///< over the noise floor, with nobody else in the air
    int lqi = 0;
    double margin = 0;     ///< over the receiver's MinReceivePower: below 0 nothing is received
    double packetLoss = 0; ///< probability, with nobody else in the air
    bool sameChannel = true;
};

/// Not to be asked on two threads at once.
class RadioNodes {
public:
    RadioNodes(const MediumSettings& settings, std::vector<RadioNode> nodes);

    [[nodiscard]] const MediumSettings& settings() const { return m_settings; }
    [[nodiscard]] const std::vector<RadioNode>& all() const { return m_nodes; }
    [[nodiscard]] std::optional<RadioId> find(std::string_view path) const;

    /// Where the bodies stand from now on, in BodyPoses' order. An antenna whose body has no pose stays.
    void place(const std::vector<Pose>& bodies);
    /// What stands between; asked only where walls take something away.
    void setWalls(WallCount walls) { m_links.setWalls(std::move(walls)); }
    /// Its pose in the world and its pattern; null is isotropic.
    [[nodiscard]] const AntennaPlace& antenna(RadioId node) const { return m_places[node]; }

    [[nodiscard]] const RadioOffsets& offsets(RadioId node) const { return m_offsets[node]; }

    /// As a packet of `payload` bytes sent with `power` would find it.
    [[nodiscard]] LinkReport link(RadioId from, RadioId to, double power, std::uint32_t payload = 20) const;
    /// What an antenna anywhere would get: for maps. A copy of antenna(), put elsewhere, gets what that radio would get there.
    [[nodiscard]] LinkBudget reach(RadioId from, const AntennaPlace& there, double power) const;

private:
    MediumSettings m_settings;
    LinkModel m_links;
    std::vector<RadioNode> m_nodes;
    std::vector<AntennaPlace> m_places;
    std::vector<RadioOffsets> m_offsets;
};

} // namespace trundle
