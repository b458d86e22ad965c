#pragma once
#include <string>
#include <string_view>

namespace trundle {

/// `[0.42 robot0] touch`, one such line for each line of the text, line ends included.
[[nodiscard]] std::string consoleLines(double time, std::string_view who, int severity, std::string_view text);

} // namespace trundle
