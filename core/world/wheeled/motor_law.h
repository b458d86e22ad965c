#pragma once
// What a motor gives a wheel in one tick, as a function of the wheel's angular momentum without it.
//
// Method: a motor is a line, torque = slope (rate - spin), between two limits; a servo is a steep line between the lines of the motor at
// full voltage forwards and backwards. Dry friction opposes the spin, and holds the wheel at rest. Each piece is linear in the spin at the
// end of the tick (implicit Euler), so the spin is linear in
// the momentum piece by piece, and falls nowhere.

#include "world/wheeled/wheeled_objects.h"

namespace trundle {

class MotorLaw {
public:
    /// Over a tick of h seconds; `load`: the largest inertia that it may move, kg m^2.
    MotorLaw(const WheelState& wheel, double damping, double load, double h);
    MotorLaw() = default;

    /// One linear piece: spin = (momentum + offset) * mobility.
    struct Piece {
        double offset = 0, mobility = 0;
        [[nodiscard]] double spin(double momentum) const { return (momentum + offset) * mobility; }
    };
    /// That holds at this momentum.
    [[nodiscard]] Piece at(double momentum) const { return m_dry > 0 ? withDry(momentum) : driven(momentum); }
    /// Of motor and friction, N m s.
    [[nodiscard]] double impulse(double momentum) const { return at(momentum).spin(momentum) / m_rest - momentum; }
    /// Of the motor alone.
    [[nodiscard]] double motorImpulse(double momentum) const;
    [[nodiscard]] double spin(double momentum) const { return at(momentum).spin(momentum); }

private:
    /// Without dry friction.
    [[nodiscard]] Piece driven(double momentum) const { // more spin is more torque at the same momentum
        Piece piece = m_line;
        double spin = piece.spin(momentum);
        for (int i = 0; i < m_limits; ++i)
            if (const double most = m_most[i].spin(momentum); spin > most) {
                piece = m_most[i];
                spin = most;
            }
        for (int i = 0; i < m_limits; ++i)
            if (const double least = m_least[i].spin(momentum); spin < least) {
                piece = m_least[i];
                spin = least;
            }
        return piece;
    }
    [[nodiscard]] Piece withDry(double momentum) const;
    [[nodiscard]] Piece line(double slope, double rate) const { return {slope * rate, 1 / (1 / m_rest + slope)}; }
    [[nodiscard]] Piece constant(double impulse) const { return {impulse, m_rest}; }

    double m_rest = 1; ///< 1 / (inertia and damping over a tick)
    double m_dry = 0;  ///< of dry friction, N m s
    Piece m_line;
    Piece m_most[2], m_least[2]; ///< of torque
    int m_limits = 0;            ///< of each of the two
};

} // namespace trundle
