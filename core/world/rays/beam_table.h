#pragma once
// Cosines and sines of the beams of a fan. Sensors of one kind share a table, which is computed at their first cast.

#include <array>
#include <memory>
#include <vector>

#include "world/rays/ray_query.h"

namespace trundle {

/// cos and sin by polynomials (of fdlibm; within 1.5e-16) for |angle| up to 1e5 rad: the same bits on every machine, since those of the C
/// library depend on the processor.
struct Direction {
    double cosine = 1, sine = 0;
};
[[nodiscard]] Direction directionOf(double angle);

struct BeamTable {
    explicit BeamTable(const RayFan& fan);

    double firstBearing, bearingStep;
    std::uint32_t count;
    std::vector<double> elevations;
    std::vector<double> cosines, sines; ///< of bearings, with padding behind them
    std::vector<Direction> layers;

    [[nodiscard]] bool fits(const RayFan& fan) const;
    /// In the axes of the fan.
    [[nodiscard]] Vec3 direction(std::size_t layer, std::uint32_t beam) const {
        const double c = layers[layer].cosine;
        return {c * cosines[beam], c * sines[beam], layers[layer].sine};
    }
    /// Elements of one layer, so that a register of beams may be read behind its last one.
    [[nodiscard]] std::size_t stride() const { return cosines.size(); }
};

/// The tables of the fans that were cast last.
class BeamTables {
public:
    [[nodiscard]] const BeamTable& of(const RayFan& fan);

private:
    std::array<std::unique_ptr<BeamTable>, 32> m_tables;
    std::size_t m_last = 0, m_next = 0; ///< used last; replaced next
};

} // namespace trundle
