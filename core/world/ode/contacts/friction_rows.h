#pragma once
// Coulomb's cone as two rows of a solver that bounds each row by itself. Method: the first row lies along the slip, or along what
// is about to slip, where its bound is the cone's own; across it the force grows with the speed as the cone's edge turns with the
// slip. The limit may be an ellipse.

#include <trundle/geometry.h>

namespace trundle {

/// Force at most load * (along, across) in two directions of the contact's plane.
struct FrictionLaw {
    Vec3 normal = Vec3::UnitZ();
    Vec3 direction = Vec3::UnitX(); ///< in the plane, unit: of `along`
    double along = 0, across = 0;
    double swing = 0; ///< m/s, of a wheel along `direction`: by how much its speed may be off because it turns in the tick
};

/// How the contact moves and what it carried; the vectors lie in its plane.
struct FrictionState {
    Vec3 slip = Vec3::Zero(); ///< m/s, of the first body on the second
    Vec3 grip = Vec3::Zero(); ///< N on the first body in the last tick
    double load = 0;          ///< N along the normal in the last tick
};

struct FrictionRows {
    Vec3 axis;                         ///< of the first row; the second is normal x axis
    double limit = 0, acrossLimit = 0; ///< N per N of load
    double give = 0;                   ///< m/s per N of the second row
    double creep = 0;                  ///< m/s: speed of the second row at which it has no force
};

/// So narrow an ellipse is a line: what has rollers.
[[nodiscard]] bool isBar(const FrictionLaw& law);
/// Of a force per load. A limit that is narrow enough to be a bar has no corners to leave.
[[nodiscard]] bool isInside(const FrictionLaw& law, const Vec3& grip);

/// `rest` is the first row's axis where nothing slips.
[[nodiscard]] FrictionRows frictionRows(const FrictionLaw& law, const FrictionState& state, const Vec3& rest);

} // namespace trundle
