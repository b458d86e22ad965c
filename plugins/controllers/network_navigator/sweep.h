#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

/// Collects RSSI samples of each sender while the robot turns, and finds the bearing of the strongest signal.
class Sweep {
public:
    struct Sample {
        double heading; ///< rad, of the antenna
        double rssi;    ///< dBm
    };
    struct Bearing {
        double heading = 0; ///< rad, in (-pi, pi]
        double rssi = 0;    ///< dBm, at the peak
    };

    void clear() { m_samples.clear(); }
    void add(std::uint32_t sender, double heading, double rssi) { m_samples[sender].push_back({heading, rssi}); }
    [[nodiscard]] const std::map<std::uint32_t, std::vector<Sample>>& samples() const { return m_samples; }
    /// Peak of the parabola through the samples around the strongest one; empty if there are too few.
    [[nodiscard]] std::optional<Bearing> bearing(std::uint32_t sender) const;

private:
    std::map<std::uint32_t, std::vector<Sample>> m_samples;
};

[[nodiscard]] double wrapAngle(double angle);
