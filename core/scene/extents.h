#pragma once
#include "model/body_spec.h"
#include "scene/bounds.h"

namespace trundle {

/// Box around a geom in the world, tight; empty for a plane and for what cannot be drawn.
[[nodiscard]] Bounds boundsOf(const GeomSpec& geom, const Pose& owner);

/// A ball around a geom, in the frame of its owner. A plane's radius is infinite; of what cannot be drawn it is below 0.
struct Ball {
    Vec3 centre = Vec3::Zero();
    double radius = -1;
};
[[nodiscard]] Ball ballAround(const GeomSpec& geom);

} // namespace trundle
