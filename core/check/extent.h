#pragma once
// Extents of shapes along a direction.

#include "model/experiment_spec.h"

namespace trundle {

/// The lowest and the highest value of `direction . x` (unit vector, world frame) over a geom with pose `X_WG`.
struct Extent {
    double low = 0, high = 0;
};
[[nodiscard]] Extent extentAlong(const GeomSpec& geom, const Pose& X_WG, const Vec3& direction);
/// Over all shapes that collide of a robot with pose `X_WR`; of one without any, low is above high.
[[nodiscard]] Extent extentAlong(const RobotConfigSpec& config, const Pose& X_WR, const Vec3& direction);
/// The box around a body's shapes, in the axes and with the origin of the body's frame; of a body without any, low is above high.
struct BodyBox {
    Vec3 low, high;
};
[[nodiscard]] BodyBox boxAround(const BodySpec& body);
/// A geom's smallest width, m.
[[nodiscard]] double smallestWidth(const GeomSpec& geom);

} // namespace trundle
