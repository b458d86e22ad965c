#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

/// What a robot that turns hears of each sender, and from where it is heard best.
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
    /// Top of the parabola through the samples around the best of them. Nothing where there are too few.
    [[nodiscard]] std::optional<Bearing> bearing(std::uint32_t sender) const;

private:
    std::map<std::uint32_t, std::vector<Sample>> m_samples;
};

[[nodiscard]] double wrapAngle(double angle);
