#pragma once
// Ground areas covered by geoms, for placing robots clear of scenery.

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "model/experiment_spec.h"

namespace trundle {

/// A ground area: a convex polygon (counter-clockwise; may be a point or a line) grown by a radius, from height low to high.
struct Footprint {
    std::vector<Eigen::Vector2d> corners;
    double grown = 0;
    double low = 0, high = 0;

    /// Whether a disc with the given height range overlaps it.
    [[nodiscard]] bool meets(const Eigen::Vector2d& centre, double radius, double discLow, double discHigh) const;
};

/// The footprints of a geom whose body is at `pose`. Empty for planes, height fields and geoms that do not collide.
[[nodiscard]] std::vector<Footprint> footprintsOf(const GeomSpec& geom, const Pose& pose);

/// The disc around the config's origin that contains the robot at any heading.
struct RobotDisc {
    double radius = 0, low = 0, high = 0;
};
[[nodiscard]] RobotDisc discOf(const RobotConfigSpec& config);
/// The same for scenery. `moving`: its bodies; null: there are none.
[[nodiscard]] RobotDisc discOf(const std::vector<GeomSpec>& geoms, const RobotConfigSpec* moving);

} // namespace trundle
