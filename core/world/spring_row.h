#pragma once
// How a spring with damper becomes one implicit row of a solver whose positions advance with the new velocity.

namespace trundle {

/// The force over one step: -stiffness * q - give * (new rate) - carry * (old rate).
struct SpringRow {
    double give = 0, carry = 0; ///< N s/m
};

/// The fastest free oscillation that a step can follow, rad per step. Coupled springs may swing 1.4 times as fast.
inline constexpr double kMaxSpringTurn = 1.8;

/// The angle by which the oscillator of this stiffness (N/m), damping (N s/m) and inertia (kg) turns in a step of `h`, rad; 0 if it
/// does not oscillate.
[[nodiscard]] double springTurn(double stiffness, double damping, double inertia, double h);

/// With the oscillator's own inertia its frequency, its decay and its rest position are exact; with another one they are of second
/// order. A faster oscillator than kMaxSpringTurn is integrated by implicit Euler, stable and strongly damped.
[[nodiscard]] SpringRow springRow(double stiffness, double damping, double inertia, double h);

} // namespace trundle
