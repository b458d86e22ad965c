#pragma once
// Which beams of a fan can meet a ball or a box. The bounds only choose what is tested exactly, so they may be rough, with a margin.

#include <trundle/geometry.h>

#include "world/rays/beam_table.h"
#include "world/rays/centre_grid.h"

namespace trundle {

/// Bearings from lo to hi, rad.
struct BearingSector {
    double lo, hi;
};

class FanView {
public:
    /// Both outlive this.
    FanView(const RayFan& fan, const BeamTable& table);

    /// A ball in the axes of the fan: its distance from the fan's axis, its height above the fan's plane.
    struct Aim {
        double rho, height;
        BearingSector sector;
        bool holds; ///< the fan is in it or above it: the sector is a full turn
    };
    /// False: the ball is out of range.
    [[nodiscard]] bool reaches(const GeomBall& ball) const {
        const double x = ball.x - m_fan.origin.x(), y = ball.y - m_fan.origin.y(), z = ball.z - m_fan.origin.z(),
                     far = m_fan.range + ball.r;
        return x * x + y * y + z * z <= far * far;
    }
    /// Of a ball in range. False: no beam can meet it.
    [[nodiscard]] bool aim(const GeomBall& ball, Aim& aim) const;
    /// Whether beams of this layer can meet the ball.
    [[nodiscard]] bool crosses(std::size_t layer, const Aim& aim, double radius) const {
        const Direction& d = m_table.layers[layer];
        return std::abs(aim.height * d.cosine - aim.rho * d.sine) <= radius;
    }
    /// The bearings of a box around a geom in which the fan is not; a full turn where they have no bounds.
    [[nodiscard]] BearingSector sectorOf(const Vec3& centre, const Mat3& axes, const Vec3& half) const;
    /// run(first, last) for the beams of a sector, and perhaps their neighbours.
    template <class Run> void beamsIn(const BearingSector& sector, Run run) const;
    /// A box around all beams, tight if they are few and narrow.
    void bounds(Vec3& lo, Vec3& hi) const;

    [[nodiscard]] const RayFan& fan() const { return m_fan; }
    [[nodiscard]] const BeamTable& table() const { return m_table; }

private:
    const RayFan& m_fan;
    const BeamTable& m_table;
    bool m_flat;                           ///< a single layer at elevation 0
    double m_lowest, m_highest, m_perStep; ///< bearings, rad; 1 / step, 0 if all bearings are equal
};

template <class Run> void FanView::beamsIn(const BearingSector& sector, Run run) const {
    constexpr double kTurn = 6.283185307179586477, kPerTurn = 1 / kTurn;
    const int last = static_cast<int>(m_table.count) - 1;
    if (m_perStep == 0 || sector.hi - sector.lo >= kTurn) return run(0, last);
    const auto floorOf = [](double x) { return static_cast<int>(x + 8192) - 8192; }; // bearings have at most some thousand turns
    const int from = -floorOf((sector.hi - m_lowest) * kPerTurn), to = floorOf((m_highest - sector.lo) * kPerTurn);
    for (int turn = from; turn <= to; ++turn) {
        double a = (sector.lo + turn * kTurn - m_table.firstBearing) * m_perStep;
        double b = (sector.hi + turn * kTurn - m_table.firstBearing) * m_perStep;
        if (a > b) std::swap(a, b);
        if (b < 0 || a > last) continue;
        run(a > 0 ? static_cast<int>(a) : 0, b < last ? static_cast<int>(b) : last);
    }
}

} // namespace trundle
