#pragma once
#include <string>

#include <QString>

#include "project/loading/project.h"
#include "project/objects/object_values.h"

namespace trundle {

/// Unit and range of a property, or the limits that a Param is described with; empty: there are none.
[[nodiscard]] QString rangeOf(const FieldValue& value);

/// The documentation of a Param: its Help, else the comment after its declaration, else the comment lines directly above it; empty if there is
/// none. `path` as in FieldValue: of an instance that sets it, or of the block that declares it.
[[nodiscard]] QString paramHelp(const LoadedProject& loaded, const std::string& path);

} // namespace trundle
