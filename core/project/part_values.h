#pragma once
// What a property holds where it stands, and numbers as a person would write them.

#include <optional>
#include <string>

#include <trundle/geometry.h>

#include "project/object_place.h"

namespace trundle {

/// With the Params and overrides of the instance where it is reached through one; its default where nothing is given. Nothing
/// where there is no value or it cannot be read.
[[nodiscard]] std::optional<PropertyValue> valueAt(const Loaded& loaded, const ObjectPlace& place, const std::string& key);
/// As it would be written: numbers in the text's unit, quotes where words need them.
[[nodiscard]] std::string valueText(const Property& property, const PropertyValue& value);
/// As few digits as stand for the number to 1e-10.
[[nodiscard]] std::string shortNumber(double value);

/// Of a body, geom or instance in what holds it: its Pos and HPR.
[[nodiscard]] Pose poseAt(const Loaded& loaded, const ObjectPlace& place);
/// "0.1,0,0.05".
[[nodiscard]] std::string positionText(const Vec3& position);
/// In degrees.
[[nodiscard]] std::string headingText(const Quat& rotation);

} // namespace trundle
