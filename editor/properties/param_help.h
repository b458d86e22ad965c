#pragma once
#include <string>

#include <QString>

#include "project/project.h"

namespace trundle {

/// What the author says of a Param: the comment behind its declaration, else the comment lines right above it; empty where there is
/// none. `path` as in FieldValue: of an instance that sets it, or of the block that declares it.
[[nodiscard]] QString paramHelp(const Loaded& loaded, const std::string& path);

} // namespace trundle
