#pragma once
#include <string>

#include "base/result.h"

namespace trundle {

/// Checks a library before any of its code runs: it must be a regular file and a complete ELF shared object of this machine that
/// exports the module entry symbol. The error message begins with the path (E403, E404, E405).
[[nodiscard]] Status checkModuleFile(const std::string& path);
/// The same; returns the bytes that were checked.
[[nodiscard]] Result<std::string> readModuleFile(const std::string& path);

} // namespace trundle
