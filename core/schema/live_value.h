#pragma once
#include <string>

#include <trundle/abi.h>

#include "base/result.h"
#include "schema/kind.h"

namespace trundle {

/// Sets a field of a device or controller during a run. Fails if the kind has no such field, if the field is not live, if the
/// value does not fit its type or limits, or if the object's own code refuses it. `who` is its name in messages.
[[nodiscard]] Status setLive(const TrundleKind& kind, void* instance, const std::string& who, const std::string& property,
                             const PropertyValue& value);

} // namespace trundle
