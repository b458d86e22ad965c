#pragma once
// The ground that things cover, for placing robots clear of scenery.

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "model/experiment_spec.h"

namespace trundle {

/// What stands on a piece of ground: a convex polygon (counter-clockwise; a point or a line too) grown by a radius, from low to high.
struct Footprint {
    std::vector<Eigen::Vector2d> corners;
    double grown = 0;
    double low = 0, high = 0;

    /// Whether a disc of the given height range touches it.
    [[nodiscard]] bool meets(const Eigen::Vector2d& centre, double radius, double discLow, double discHigh) const;
};

/// Of a geom that stands at `pose` (times its own). Nothing for planes, height fields and what does not collide.
[[nodiscard]] std::vector<Footprint> footprintsOf(const GeomSpec& geom, const Pose& pose);

/// The disc about the config's origin that a robot covers, whatever way it faces.
struct RobotDisc {
    double radius = 0, low = 0, high = 0;
};
[[nodiscard]] RobotDisc discOf(const RobotConfigSpec& config);

} // namespace trundle
