#pragma once
#include <string>
#include <string_view>

namespace trundle {

/// `[0.42 robot0] touch`: one such line, with line end, per line of the text.
[[nodiscard]] std::string consoleLines(double time, std::string_view who, int severity, std::string_view text);

} // namespace trundle
