#pragma once
// How a rigid body turns on which no torque acts. Method: its energy is that of a ball, which turns it about its angular momentum,
// plus two terms that turn it about its own principal axes. Each is a rotation in closed form, so that the momentum stays exact;
// they are composed to fourth order, and for a symmetric top they are the whole solution.

#include <trundle/geometry.h>

namespace trundle {

/// Inertia about the centre of mass, in the body's axes.
class RotationalInertia {
public:
    RotationalInertia() = default;
    explicit RotationalInertia(const Mat3& inertia);

    /// All moments are equal: nothing to compute.
    [[nodiscard]] bool isRound() const { return m_round; }
    /// rad/s from an angular momentum in the world.
    [[nodiscard]] Vec3 rate(const Quat& rotation, const Vec3& momentum) const;
    [[nodiscard]] Vec3 momentum(const Quat& rotation, const Vec3& rate) const;

    /// Where the body has turned to after `h` seconds.
    [[nodiscard]] Quat turnedFreely(const Quat& rotation, const Vec3& momentum, double h) const;
    /// How the rate changes in `h` seconds by the midpoint rule, times the inertia; all in the body's axes.
    [[nodiscard]] Vec3 changeByMidpoint(const Vec3& rate, double h) const;

private:
    Mat3 m_tensor = Mat3::Identity(), m_inverse = Mat3::Identity();
    bool m_round = true;
    Quat m_axes = Quat::Identity();   ///< principal axes in the body's
    double m_ball = 1;                ///< 1 / moment about the first axis
    double m_second = 0, m_third = 0; ///< of the other axes, less m_ball; the second is the lesser
};

/// A rotation by a vector: its axis times the angle in rad.
[[nodiscard]] Quat turnedBy(const Vec3& rotation);

/// The constant rate that turns `from` into `to` in `h` seconds, of the many the one next to `expected`.
[[nodiscard]] Vec3 meanRate(const Quat& from, const Quat& to, double h, const Vec3& expected);

} // namespace trundle
