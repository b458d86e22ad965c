#pragma once
#include <QString>

#include "editor/properties/object_values.h"

namespace trundle {

/// "robots/simple_robot.sim:22"; empty where the place is in no text.
[[nodiscard]] QString placeWords(const Loaded& loaded, const SourceRange& place);
/// "default", "set here", "override here", "from SimpleRobot", with " (a formula)".
[[nodiscard]] QString originWords(const FieldValue& value);

} // namespace trundle
