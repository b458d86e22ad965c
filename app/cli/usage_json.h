#pragma once
#include <string>
#include <string_view>

namespace trundle {

/// Whether `--json` is among the arguments.
[[nodiscard]] bool asksForJson(int argc, char** argv);
/// The --json output for an invalid command line: the usual structure of the command with one diagnostic whose code is "usage".
/// `run`: its object; `check`: a list; others: {"diagnostics": [...]}.
[[nodiscard]] std::string usageJson(std::string_view command, const std::string& message);

} // namespace trundle
