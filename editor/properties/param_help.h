#pragma once
#include <string>

#include <QString>

#include "project/loading/project.h"

namespace trundle {

/// The documentation of a Param: the comment after its declaration, else the comment lines directly above it; empty if there is
/// none. `path` as in FieldValue: of an instance that sets it, or of the block that declares it.
[[nodiscard]] QString paramHelp(const LoadedProject& loaded, const std::string& path);

} // namespace trundle
