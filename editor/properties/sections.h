#pragma once
#include <QString>

#include "schema/kind.h"

namespace trundle {

/// Under which heading a property stands: what is common to many kinds (place, mass, look) apart from what makes the kind.
[[nodiscard]] QString sectionOf(const Kind& kind, const Property& property);

} // namespace trundle
