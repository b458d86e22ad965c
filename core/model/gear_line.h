#pragma once
// Where two joints that are geared together act on each other, as gear wheels do in their pitch point.

#include <optional>
#include <string>

#include "model/joint_spec.h"

namespace trundle {

/// The line that a joint turns about, or slides along.
struct JointLine {
    bool slides = false;
    Vec3 point = Vec3::Zero(), axis = Vec3::UnitZ(); ///< unit vector
};

/// What acts between the ends of two joints on a common body: a force along `direction` through `point`, or a torque along it.
struct GearLine {
    bool isTorque = false;
    Vec3 point = Vec3::Zero(), direction = Vec3::UnitZ(); ///< unit vector
    double lever = 1; ///< along the first joint per force (m about a hinge, no unit along a slider) or per torque
};

/// Acts along the second line `share` times as it does along the first. Nothing if no single force or torque does.
[[nodiscard]] std::optional<GearLine> gearLine(const JointLine& first, const JointLine& second, double share);

/// Which ends of two joints a gear acts between: the ones that they do not have in common. Bodies by index, kWorldBody for the world.
struct GearEnds {
    int first = 0, second = 0;
    double firstSense = 1, secondSense = 1; ///< -1: the common body is the joint's child
};
[[nodiscard]] std::optional<GearEnds> gearEnds(int parent, int child, int otherParent, int otherChild);

/// Why these two joints cannot be geared in this ratio; nothing if they can.
[[nodiscard]] std::optional<std::string> gearFault(const JointSpec& joint, const JointSpec& other, double ratio);

} // namespace trundle
