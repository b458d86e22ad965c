#pragma once
#include <QString>

#include "schema/kind.h"

namespace trundle {

/// The section of a property: properties common to many kinds (pose, mass, appearance) are separate from those specific to the
/// kind.
[[nodiscard]] QString sectionOf(const Kind& kind, const Property& property);

} // namespace trundle
