#pragma once
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "base/diagnostic.h"
#include "lang/source_text.h"

namespace trundle {

/// [{file, line, column, end_line, end_column, severity, code, message, suggestions, fixes: [{title, edits}]}], end exclusive.
/// Lines and columns count from 1; 0 and an empty file for a message without a source range. `more` is present only with E116,
/// the last message of a file with more errors than are listed, and is the number of the others.
[[nodiscard]] nlohmann::ordered_json diagnosticsJson(const std::vector<Diagnostic>& diagnostics, const SourceTable& sources);
/// The entries of that array as text, without its brackets.
[[nodiscard]] std::string diagnosticEntries(const std::vector<Diagnostic>& diagnostics, const SourceTable& sources);
/// The object as text; invalid UTF-8 becomes U+FFFD, control characters are escaped.
[[nodiscard]] std::string jsonText(const nlohmann::ordered_json& json);

} // namespace trundle
