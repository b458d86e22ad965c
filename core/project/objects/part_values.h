#pragma once
// Values of properties at an object, and numbers formatted for the text.

#include <optional>
#include <string>

#include <trundle/geometry.h>

#include "project/objects/object_location.h"

namespace trundle {

/// The value of a property, with the Params and overrides of the instance that the object is reached through; the default if none
/// is given. Nothing if there is no value or it is invalid.
[[nodiscard]] std::optional<PropertyValue> valueAt(const LoadedProject& loaded, const ObjectLocation& place,
                                                   const std::string& key);
/// What the instance that an object is reached through sets for a property or Param of it, of a member of a Repeat also for all
/// members; nullptr: nothing.
[[nodiscard]] const SourceAssignment* overrideAt(const LoadedProject& loaded, const ObjectLocation& place,
                                                 const std::string& key);
/// The value as written in a file: numbers in the property's unit, quotes where needed.
[[nodiscard]] std::string valueText(const Property& property, const PropertyValue& value);
/// With the fewest digits that represent the number to 1e-10.
[[nodiscard]] std::string shortNumber(double value);

/// Pose of a body, geom or instance relative to its parent, from Pos and HPR.
[[nodiscard]] Pose poseAt(const LoadedProject& loaded, const ObjectLocation& place);
/// The bodies of the robot's config that an object is in, as the instance has them; of a path into the config, those of the first
/// instance. nullptr without an instance.
[[nodiscard]] const RobotConfigSpec* resolvedConfig(const LoadedProject& loaded, const ObjectLocation& place);
/// What comes before the name of an object there: "left.", "row_2.arm.".
[[nodiscard]] std::string resolvedPrefix(const ObjectLocation& place);
/// The frame in which a block inside a Part is described, in the frame of the config or scenery: first the mirror image, then the
/// pose. For an object that is in no Part that is the frame of the config.
struct DescribedFrame {
    Pose pose;
    Vec3 signs = Vec3::Ones(); ///< -1 along mirrored axes

    /// The mirror image of a pose, which is its own inverse.
    [[nodiscard]] Pose mirrored(const Pose& described) const;
};
[[nodiscard]] DescribedFrame describedFrame(const LoadedProject& loaded, const ObjectLocation& place);
/// Pose of a body or Part in the frame of the config or scenery, also where it counts from another body by In.
[[nodiscard]] Pose poseInConfig(const LoadedProject& loaded, const ObjectLocation& place);
/// A position (m) as text: "0.1,0,0.05".
[[nodiscard]] std::string positionText(const Vec3& position);
/// HPR in degrees as text.
[[nodiscard]] std::string headingText(const Quat& rotation);

} // namespace trundle
