#pragma once
#include <string>
#include <vector>

#include "base/diagnostic.h"
#include "lang/source_text.h"

namespace trundle {

/// Prints diagnostics on standard error as text: the first hundred, errors before all others.
void printDiagnostics(const std::vector<Diagnostic>& diagnostics, const SourceTable& sources);
/// Prints one line on standard error, `trundle-cli: ...`.
void printProblem(const std::string& text);
/// "2 errors, 1 warning"; empty if there are neither. Hints are not counted.
[[nodiscard]] std::string countText(const std::vector<Diagnostic>& diagnostics);
/// Writes bytes to the program's original standard output. On failure reports the error on standard error and returns false.
bool writeOut(const std::string& bytes);

} // namespace trundle
