#pragma once
// Link budgets between radios at chosen poses, without a run: term by term, as a frame in a run would have them. For windows and
// maps. scene/queries/radio_model.h finds the radios of an experiment and the solids between them.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "radio/link_budget.h"
#include "radio/radio_figures.h"

namespace trundle {

/// A radio of an experiment and the mounting of its antenna.
struct RadioNode {
    RadioDefinition radio; ///< path "robot0/radio", antenna, levels; its address as written, 0 if the run assigns it
    std::string robot;
    std::size_t body = 0; ///< index of its body, as in BodyPoses
    Pose mounting;        ///< pose of the antenna in that body; main direction +x, up +z
};

/// One link, dBm and dB.
struct LinkReport {
    double outputPower = 0; ///< of the sender: the nearest available level plus its offset
    LinkBudget link;        ///< link.power = outputPower + sendGain + receiveGain - pathLoss - shadow - wallLoss
    double rssi = 0;        ///< as the receiver reads it
    double snr = 0;         ///< over the noise floor, without interference
    int lqi = 0;
    double margin = 0;     ///< over the receiver's MinReceivePower; nothing is received below 0
    double packetLoss = 0; ///< probability, without interference
    bool sameChannel = true;
};

/// Not thread-safe, not even for const calls.
class RadioNodes {
public:
    RadioNodes(const MediumSettings& settings, std::vector<RadioNode> nodes);

    [[nodiscard]] const MediumSettings& settings() const { return m_settings; }
    [[nodiscard]] const std::vector<RadioNode>& all() const { return m_nodes; }
    [[nodiscard]] std::optional<RadioId> find(std::string_view path) const;

    /// Sets the poses of all bodies (world frame), in BodyPoses' order. An antenna whose body has no pose keeps its own.
    void place(const std::vector<Pose>& bodies);
    /// Counts the solids between two antennas; called only if walls have a loss.
    void setWalls(WallCount walls) { m_links.setWalls(std::move(walls)); }
    /// Its pose in the world frame and its pattern; null means isotropic.
    [[nodiscard]] const AntennaPose& antenna(RadioId node) const { return m_places[node]; }

    [[nodiscard]] const RadioOffsets& offsets(RadioId node) const { return m_offsets[node]; }

    /// The link for a packet of `payload` bytes sent with `power` (dBm).
    [[nodiscard]] LinkReport link(RadioId from, RadioId to, double power, std::uint32_t payload = 20) const;
    /// Received power at an antenna with any pose, for maps. To move a radio, pass a copy of its antenna() with another pose.
    [[nodiscard]] LinkBudget reach(RadioId from, const AntennaPose& there, double power) const;

private:
    MediumSettings m_settings;
    LinkModel m_links;
    std::vector<RadioNode> m_nodes;
    std::vector<AntennaPose> m_places;
    std::vector<RadioOffsets> m_offsets;
};

} // namespace trundle
