#pragma once
#include <QString>

#include "project/objects/object_values.h"

namespace trundle {

class Document;

/// "robots/simple_robot.sim:22"; empty if the range is in no text.
[[nodiscard]] QString placeWords(const LoadedProject& loaded, const SourceRange& place);
/// For an override: "override here; SimpleRobot has 2 ohm".
[[nodiscard]] QString overrideWords(const FieldValue& value);
/// Where a change of the object's value is written; empty if that is its own block and no other object uses it.
[[nodiscard]] QString targetWords(const ObjectValues& object, Document& document);
/// "the default", "set here", "set in the config", or overrideWords().
[[nodiscard]] QString originWords(const FieldValue& value);

} // namespace trundle
