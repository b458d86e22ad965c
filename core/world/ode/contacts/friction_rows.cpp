#include "world/ode/contacts/friction_rows.h"

#include <algorithm>
#include <cmath>

namespace trundle {

namespace {

constexpr double kCreep = 1e-3;       // m/s: slower slip does not yet turn the rows on its own
constexpr double kNearLimit = 0.7;    // share of the limit from which the force turns the rows
constexpr double kThinEllipse = 1e-3; // narrower than that the limit is a bar

/// With the squares of both limits.
bool isBar(double m1, double m2) { return m1 < kThinEllipse * kThinEllipse * m2 || m2 < kThinEllipse * kThinEllipse * m1; }

} // namespace

bool isBar(const FrictionLaw& law) { return isBar(law.along * law.along, law.across * law.across); }

bool isInside(const FrictionLaw& law, const Vec3& grip) {
    const double m1 = law.along * law.along, m2 = law.across * law.across;
    if (m1 == m2) return grip.squaredNorm() <= m1;
    if (isBar(m1, m2)) return true;
    const double g1 = grip.dot(law.direction), g2 = grip.dot(law.normal.cross(law.direction));
    return g1 * g1 / m1 + g2 * g2 / m2 <= 1;
}

FrictionRows frictionRows(const FrictionLaw& law, const FrictionState& state, const Vec3& rest) {
    const Vec3 side = law.normal.cross(law.direction);
    const double m1 = law.along * law.along, m2 = law.across * law.across;
    if (isBar(m1, m2)) return {law.direction, law.along, law.across, 0, 0};

    // How near to its limit. Far from it nothing slips: what then looks like slip is a wheel that has turned since it was solved.
    const double g1 = state.grip.dot(law.direction), g2 = state.grip.dot(side), load2 = state.load * state.load;
    const double used2 = load2 > 0 ? (g1 * g1 / m1 + g2 * g2 / m2) / load2 : 1;
    const double near = std::clamp((std::sqrt(used2) - kNearLimit) / (1 - kNearLimit), 0.0, 1.0);

    // Which way it slips or will: the slip, towards the normal of the limit at the force, towards the axis of rest.
    Vec3 way = near * state.slip;
    if (near > 0 && load2 > 0) way -= (kCreep * near) * Vec3(g1 / m1 * law.direction + g2 / m2 * side).normalized();
    if (near < 1) way += (way.dot(rest) < 0 ? -kCreep : kCreep) * (1 - near) * rest;
    const double length = way.norm();
    if (length > 1e-9) way /= length;
    else way = rest;

    const double a = way.dot(law.direction), b = way.dot(side), speed = state.slip.norm();
    const double s2 = m1 * a * a + m2 * b * b, s = std::sqrt(s2);
    FrictionRows rows{way, s, std::sqrt(m1 * b * b + m2 * a * a), 0, 0};
    if (state.load > 0) {
        const double turn = near * speed * s2 / (m1 * m2);
        rows.give = turn * s / state.load;
        rows.creep = -turn * a * b * (m2 - m1);
    }
    return rows;
}

} // namespace trundle
