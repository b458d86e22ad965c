#pragma once
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "base/diagnostic.h"
#include "lang/source_text.h"

namespace trundle {

/// [{file, line, column, end_line, end_column, severity, code, message, suggestions, fixes: [{title, edits}]}], end exclusive. Lines and
/// columns count from 1; 0 and an empty file where a message has no place. `more` stands only with E116, the last message of a file that
/// has more mistakes than are listed: how many.
[[nodiscard]] nlohmann::ordered_json diagnosticsJson(const std::vector<Diagnostic>& diagnostics, const SourceTable& sources);
/// The entries of that list as text, without its brackets.
[[nodiscard]] std::string diagnosticEntries(const std::vector<Diagnostic>& diagnostics, const SourceTable& sources);
/// The object's text; bytes that are no UTF-8 become U+FFFD, control characters are escaped.
[[nodiscard]] std::string jsonText(const nlohmann::ordered_json& json);

} // namespace trundle
