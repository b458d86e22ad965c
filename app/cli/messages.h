#pragma once
#include <string>
#include <vector>

#include "base/diagnostic.h"
#include "lang/source_text.h"

namespace trundle {

/// Diagnostics on standard error, as people read them: the first hundred, errors before all others.
void printDiagnostics(const std::vector<Diagnostic>& diagnostics, const SourceTable& sources);
/// One line on standard error, `trundle-cli: ...`.
void printProblem(const std::string& text);
/// "2 errors, 1 warning"; empty when there is neither. Hints do not count.
[[nodiscard]] std::string countText(const std::vector<Diagnostic>& diagnostics);
/// Bytes to the standard output that the program was started with. Where it cannot take them says so on standard error and gives false.
bool writeOut(const std::string& bytes);

} // namespace trundle
