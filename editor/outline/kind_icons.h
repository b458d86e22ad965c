#pragma once
#include <QString>

#include "schema/kind.h"

namespace trundle {

/// Name of an icon in resources/icons for a kind; the icon of its role if the kind has none.
[[nodiscard]] QString kindIcon(const Kind* kind);
[[nodiscard]] QString roleIcon(Role role);

} // namespace trundle
