#pragma once

namespace trundle {

/// The play of a gear: the drive turns by up to `width` on its way from one flank of the teeth to the other, and moves nothing meanwhile.
/// Units: rad, s, N m, kg m^2 at the joint; of a slider m, N, kg.
class GearPlay {
public:
    /// What turns the drive while nothing holds it: torque = (rate - its rate) / softness, within the limit. Softness 0: it has the rate.
    struct Free {
        double rate = 0, softness = 0, limit = 0;
        double inertia = 0, dryFriction = 0, viscousFriction = 0;
    };

    /// Starts in the middle.
    void start(double width) { *this = GearPlay(width); }
    [[nodiscard]] bool exists() const { return m_width > 0; }
    /// At the start of a tick: whether a torque of this sign reaches the joint. If not, `turn` has to be called in this tick.
    [[nodiscard]] bool reaches(double torque) const;
    /// The same for a drive that takes the joint to another rate; within `slack` of it, what it did in the last tick counts.
    [[nodiscard]] bool reaches(double rateError, double slack, double lastTorque) const;
    /// The drive turns freely, and the joint at `jointRate` before the tick; returns the torque that drives it. Implicit Euler method.
    double turn(const Free& drive, double jointRate, double tick);
    /// At the end of the tick. Returns the momentum that the drive gives to the joint where the teeth meet.
    double follow(double jointRate, double tick);

    [[nodiscard]] bool isFree() const { return m_isFree; }
    [[nodiscard]] double rate() const { return m_rate; } ///< of the drive, as long as it is free

    GearPlay() = default;

private:
    explicit GearPlay(double width) : m_width(width) {}

    double m_width = 0;
    double m_at = 0; ///< of the drive ahead of the joint, from -width / 2 to width / 2
    double m_rate = 0, m_inertia = 0;
    bool m_isFree = false, m_wasFree = false;
};

} // namespace trundle
