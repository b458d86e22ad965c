#pragma once
#include <QString>

#include "editor/properties/object_values.h"

namespace trundle {

class Document;

/// "robots/simple_robot.sim:22"; empty where the place is in no text.
[[nodiscard]] QString placeWords(const Loaded& loaded, const SourceRange& place);
/// Of an override: "override here; SimpleRobot has 2 ohm".
[[nodiscard]] QString overrideWords(const FieldValue& value);
/// Where a value of the object goes that is changed now; empty where that is its own block and nobody else's.
[[nodiscard]] QString targetWords(const ObjectValues& object, const Document& document);
/// "the default", "set here", "set in the config", or overrideWords().
[[nodiscard]] QString originWords(const FieldValue& value);

} // namespace trundle
