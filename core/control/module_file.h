#pragma once
#include <string>

#include "base/result.h"

namespace trundle {

/// Looks at a library before any of its code runs: a regular file, an ELF shared object of this machine, complete, exporting the
/// entry symbol of a module. Fails with what is wrong, the path first (E403, E404, E405).
[[nodiscard]] Status checkModuleFile(const std::string& path);
/// The same, and gives the bytes that it looked at.
[[nodiscard]] Result<std::string> readModuleFile(const std::string& path);

} // namespace trundle
