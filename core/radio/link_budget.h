#pragma once
// What arrives of what is sent, between two antennas as they stand.

#include <functional>
#include <unordered_map>

#include "radio/radio_settings.h"
#include "radio/radio_trace.h"

namespace trundle {

/// How many solids stand between two points; those of the two radios' own robots do not count. Asked from the lower id to the higher.
using WallCount = std::function<int(RadioId, const Vec3&, RadioId, const Vec3&)>;

/// One end of a link.
struct AntennaPlace {
    RadioId id = kNoRadio;
    std::uint64_t key = 0; ///< of its path: the same whoever else is there
    Pose pose;
    const AntennaPattern* pattern = nullptr;
};

class LinkModel {
public:
    explicit LinkModel(const MediumSettings& settings) : m_settings(settings), m_lambda(wavelengthOf(settings)) {}
    void setWalls(WallCount walls) { m_walls = std::move(walls); }

    /// The same loss in both directions, to the last bit. `outputPower` is what leaves the sender.
    [[nodiscard]] LinkBudget between(const AntennaPlace& from, const AntennaPlace& to, double outputPower) const;
    /// Farther away nothing arrives that is stronger than `power`; `budget` is what leaves with the best gains of both ends.
    [[nodiscard]] double range(double budget, double power) const;

private:
    [[nodiscard]] static double wavelengthOf(const MediumSettings& settings);
    struct Obstacles {
        Vec3 a, b;
        double shadow = 0, walls = 0;
    };
    [[nodiscard]] const Obstacles& obstacles(const AntennaPlace& low, const AntennaPlace& high) const;

    MediumSettings m_settings;
    double m_lambda;
    WallCount m_walls;
    mutable std::unordered_map<std::uint64_t, Obstacles> m_obstacles; ///< by pair of ids; looked up, never walked
};

} // namespace trundle
