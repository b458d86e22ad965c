#pragma once
#include <string>
#include <string_view>

namespace trundle {

/// Whether `--json` stands anywhere behind the program's name.
[[nodiscard]] bool asksForJson(int argc, char** argv);
/// What --json prints where the command line itself is wrong: the shape that the command has otherwise, with one diagnostic whose code
/// is "usage". `run`: its object; `check`: a list; others: {"diagnostics": [...]}.
[[nodiscard]] std::string usageJson(std::string_view command, const std::string& message);

} // namespace trundle
