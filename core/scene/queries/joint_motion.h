#pragma once
// Where the bodies of a robot are with its joints at given positions, without dynamics.

#include <span>
#include <vector>

#include "model/experiment_spec.h"

namespace trundle {

/// One coordinate of a joint: a Hinge and a Slider have one, a Universal and a Suspension two (about or along Axis, about Axis2), a
/// Ball three (about x, y and z of the config frame).
struct JointCoordinate {
    std::size_t joint = 0; ///< index into the config's joints
    int part = 0;
    bool isAngle = true;                  ///< rad; otherwise m
    double low = 0, high = 0;             ///< its stops; of one without stops a half turn or 10 cm to each side
    bool hasLow = false, hasHigh = false; ///< whether these are stops
};

/// In the order of the config's joints. A Fixed joint has none.
[[nodiscard]] std::vector<JointCoordinate> jointCoordinates(const RobotConfigSpec& config);

/// Sets one position within its stops, and those of joints that gears couple to it. `positions` has one entry per coordinate.
void setJointPosition(const RobotConfigSpec& config, std::span<const JointCoordinate> coordinates, std::size_t which,
                      double position, std::span<double> positions);

/// The motion of each body from its start, in the config frame: its pose is motion * BodySpec::pose. The first body, or what is joined
/// to the world, stays; children follow. Of joints that close a loop the first in text order are followed, the last one is not.
[[nodiscard]] std::vector<Pose> bodyMotions(const RobotConfigSpec& config, std::span<const JointCoordinate> coordinates,
                                            std::span<const double> positions);

} // namespace trundle
