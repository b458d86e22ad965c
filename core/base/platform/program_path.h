#pragma once
#include <string>

namespace trundle {

/// Absolute path of the running executable, links resolved; empty if unknown.
[[nodiscard]] std::string programPath();
/// Its folder, without a slash at the end.
[[nodiscard]] std::string programFolder();

} // namespace trundle
