#pragma once
// Joints of a RobotConfig. Immutable, SI units.
#include <optional>
#include <string>

#include <trundle/geometry.h>

#include "base/source_range.h"

namespace trundle {

enum class JointType { Hinge, Slider, Ball, Universal, Fixed, Suspension };

inline constexpr int kWorldBody = -1;

/// Anchor and axes in the config frame at the start pose. A positive position rotates (moves) the child right-handed about
/// (along) the axis, relative to the parent. Suspension: a wheel's hinge about `axis2` whose anchor slides along `axis`.
struct JointSpec {
    std::string name;
    JointType type = JointType::Hinge;
    int parent = kWorldBody; ///< index into the config's bodies
    int child = 0;
    Vec3 anchor = Vec3::Zero();
    Vec3 axis = Vec3::UnitZ();               ///< unit vector
    Vec3 axis2 = Vec3::UnitX();              ///< unit vector
    std::optional<double> lowStop, highStop; ///< rad or m
    double damping = 0;                      ///< N m s/rad or N s/m
    double friction = 0;                     ///< N m or N, Coulomb
    double stiffness = 0;                    ///< N m/rad or N/m
    double travel = 0;                       ///< m, for Suspension
    SourceRange range;                       ///< the whole block
    SourceRange nameRange;                   ///< for diagnostics about the joint
};

} // namespace trundle
