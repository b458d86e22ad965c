#pragma once
#include <optional>
#include <string>

#include <trundle/geometry.h>

#include "base/source_range.h"

namespace trundle {

enum class JointType { Hinge, Slider, Ball, Universal, Fixed, Suspension };

inline constexpr int kWorldBody = -1;

/// Anchor and axes in the config frame at the start pose. A positive position turns (moves) the child right-handed about
/// (along) the axis as seen from the parent. Suspension: a wheel's hinge about `axis2` whose anchor slides along `axis`.
struct JointSpec {
    std::string name;
    JointType type = JointType::Hinge;
    int parent = kWorldBody; ///< index into the config's bodies
    int child = 0;
    Vec3 anchor = Vec3::Zero();
    Vec3 axis = Vec3::UnitZ();               ///< unit
    Vec3 axis2 = Vec3::UnitX();              ///< unit
    std::optional<double> lowStop, highStop; ///< rad or m
    double damping = 0;                      ///< N m s/rad or N s/m
    double friction = 0;                     ///< N m or N, Coulomb
    double stiffness = 0;                    ///< N m/rad or N/m
    double travel = 0;                       ///< m, Suspension
    SourceRange range;                       ///< the whole block
    SourceRange nameRange;                   ///< where a message about the joint points
};

} // namespace trundle
