#pragma once
// Mass of a robot as it is posed, and whether it balances on level ground.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "scene/queries/object_index.h"

namespace trundle {

/// Of all its bodies as one: mass, centre and inertia in the world frame. No mass: it has only fixed bodies.
[[nodiscard]] MassProperties massOf(const ObjectIndex& objects, std::uint32_t robot, const BodyPoses& poses);

/// The solid ellipsoid of the same mass and inertia, about the same centre: semi-axes (m) along the columns of `axes`.
/// For a solid ellipsoid I_x = m/5 (b^2 + c^2), so a^2 = 5/(2m) (I_y + I_z - I_x).
struct InertiaEllipsoid {
    Vec3 semiAxes = Vec3::Zero();
    Mat3 axes = Mat3::Identity(); ///< right-handed, of the frame of the inertia
    Vec3 moments = Vec3::Zero();  ///< kg m^2, principal
};
[[nodiscard]] InertiaEllipsoid ellipsoidOf(const MassProperties& mass);

/// How a robot rests on level ground at its lowest point, rigid as it is posed.
struct Balance {
    double level = 0;          ///< m, z of the ground
    std::vector<Vec3> polygon; ///< the convex hull of what touches it, counter-clockwise; one or two points: it has no area
    Vec3 centre;               ///< of mass, on the ground
    double height = 0;         ///< m, of the centre of mass above the ground
    double margin = 0;         ///< m, from the centre to the nearest edge; negative: outside, or the polygon has no area
    [[nodiscard]] bool isStable() const { return margin > 0; }
};
/// Where the line from the centre in a horizontal direction crosses the edge of the polygon. Only of a stable one.
[[nodiscard]] Vec3 edgeTowards(const Balance& balance, const Vec3& direction);
/// The point of the edge that is nearest to the centre: `margin` away. Only of a stable one.
[[nodiscard]] Vec3 nearestEdge(const Balance& balance);
/// rad: on ground that goes down in this direction and is steeper than this, the robot turns over. It does not slide or roll. 0: it is not stable.
[[nodiscard]] double tipAngle(const Balance& balance, const Vec3& direction);
[[nodiscard]] double leastTipAngle(const Balance& balance); ///< rad, of all directions
/// "forward 34°, backward 20°, left 31°, right 31°; least 18°", of a robot with this heading (rad). Only of a stable one.
[[nodiscard]] std::string tippingText(const Balance& balance, double heading);
/// "Stable: 32 mm to the edge", "Falls over: 5 mm beyond the edge", "Rests on a point: it may roll or tip".
[[nodiscard]] std::string balanceText(const Balance& balance);
/// Nothing for a robot that is joined to the world or to another robot, or has no mass or no colliding shapes.
[[nodiscard]] std::optional<Balance> balanceOf(const ObjectIndex& objects, std::uint32_t robot, const BodyPoses& poses);

} // namespace trundle
