#pragma once
#include "model/body_spec.h"
#include "scene/shapes/bounds.h"

namespace trundle {

/// Tight axis-aligned box around a geom in world coordinates; empty for planes and for geoms that cannot be drawn.
[[nodiscard]] Bounds boundsOf(const GeomSpec& geom, const Pose& owner);

/// Bounding sphere of a geom in its owner's frame. A plane's radius is infinite; that of a geom that cannot be drawn is negative.
struct Ball {
    Vec3 centre = Vec3::Zero();
    double radius = -1;
};
[[nodiscard]] Ball ballAround(const GeomSpec& geom);

} // namespace trundle
