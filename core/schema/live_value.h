#pragma once
#include <string>

#include <trundle/abi.h>

#include "base/result.h"
#include "schema/kind.h"

namespace trundle {

/// Sets a field of a device or controller during a run. Refused: a field that the kind does not have or does not describe as live,
/// a value it has no room for, and what the object's own code refuses. `who` is named in messages.
[[nodiscard]] Status setLive(const TrundleKind& kind, void* instance, const std::string& who, const std::string& property,
                             const PropertyValue& value);

} // namespace trundle
