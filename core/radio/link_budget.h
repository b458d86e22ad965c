#pragma once
// Received power between two antennas at given poses.

#include <functional>
#include <unordered_map>

#include "radio/radio_settings.h"
#include "radio/radio_trace.h"

namespace trundle {

/// Number of solids between two points, not counting the two radios' own robots. Called with the lower id first.
using WallCount = std::function<int(RadioId, const Vec3&, RadioId, const Vec3&)>;

/// Antenna of one end of a link.
struct AntennaPose {
    RadioId id = kNoRadio;
    std::uint64_t key = 0; ///< hash of its path, independent of other radios
    Pose pose;
    const AntennaPattern* pattern = nullptr;
};

class LinkModel {
public:
    explicit LinkModel(const MediumSettings& settings) : m_settings(settings), m_lambda(wavelengthOf(settings)) {}
    void setWalls(WallCount walls) { m_walls = std::move(walls); }

    /// Symmetric: the loss is bit for bit the same in both directions. `outputPower` (dBm) is the power that leaves the sender.
    [[nodiscard]] LinkBudget between(const AntennaPose& from, const AntennaPose& to, double outputPower) const;
    /// The distance (m) beyond which no signal is stronger than `power` (dBm); `budget` is the output power plus the best gains
    /// of both ends.
    [[nodiscard]] double range(double budget, double power) const;

private:
    [[nodiscard]] static double wavelengthOf(const MediumSettings& settings);
    struct Obstacles {
        Vec3 a, b;
        double shadow = 0, walls = 0;
    };
    [[nodiscard]] const Obstacles& obstacles(const AntennaPose& low, const AntennaPose& high) const;

    MediumSettings m_settings;
    double m_lambda;
    WallCount m_walls;
    mutable std::unordered_map<std::uint64_t, Obstacles> m_obstacles; ///< by pair of ids; iteration order is never used
};

} // namespace trundle
