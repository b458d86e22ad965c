#pragma once
// Joints of a RobotConfig, and what else couples its bodies. Immutable, SI units.
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
    double rest = 0;                         ///< rad or m, where the spring has no force; Hinge and Slider
    // Of a Universal about `axis2`; stiffness and damping as about `axis` where absent.
    std::optional<double> lowStop2, highStop2;  ///< rad
    std::optional<double> stiffness2, damping2; ///< N m/rad, N m s/rad
    std::optional<double> swingStop;            ///< rad, of a Ball: how far the child's `axis` may tilt from the parent's
    double travel = 0;                          ///< m, for Suspension
    SourceRange range;                          ///< the whole block
    SourceRange nameRange;                      ///< for diagnostics about the joint
};

/// A spring with damper along the line between a point of the parent and one of the child. Points in the config frame at the start.
struct SpringSpec {
    std::string name;
    int parent = kWorldBody; ///< index into the config's bodies
    int child = 0;
    Vec3 anchor = Vec3::Zero(), anchor2 = Vec3::Zero(); ///< of the parent, of the child
    double length = 0;                                  ///< m, without force
    double stiffness = 0;                               ///< N/m
    double damping = 0;                                 ///< N s/m
    SourceRange range, nameRange;
};

/// Keeps the rate of a Hinge or Slider at `ratio` times that of another one: position = ratio * other's position. The two joints have
/// a body, or the world, in common.
struct GearSpec {
    std::string name;
    int joint = 0, other = 0; ///< indices into the config's joints
    double ratio = 1;         ///< not 0: without a unit, or m/rad of a slider on a hinge, rad/m of a hinge on a slider
    SourceRange range, nameRange;
};

/// What joins bodies of two robots, or a body and the world, as a JointSpec or a SpringSpec: `parent` and `child` of the spec are
/// bodies of these robots, its points and axes are in the world at the start.
template <class Spec> struct Link {
    Spec spec;
    int parentRobot = kWorldBody; ///< index into the experiment's robots; kWorldBody: the world
    int childRobot = 0;
};

} // namespace trundle
