#pragma once
#include <QString>

#include "schema/kind.h"

namespace trundle {

/// Name of an icon in resources/icons for a kind; one of its role for those that nobody drew.
[[nodiscard]] QString kindIcon(const Kind* kind);
[[nodiscard]] QString roleIcon(Role role);

} // namespace trundle
