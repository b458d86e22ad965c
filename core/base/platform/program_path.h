#pragma once
#include <string>

namespace trundle {

/// Absolute path of the running executable with links resolved; empty if unknown.
[[nodiscard]] std::string programPath();
/// Its folder, without a trailing slash.
[[nodiscard]] std::string programFolder();

} // namespace trundle
