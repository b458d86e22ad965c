#pragma once
#include <QString>

namespace trundle {

/// `text` without characters that a terminal would interpret or that change how it is displayed.
[[nodiscard]] QString forTerminal(const QString& text);
/// Prints one line on standard error, `trundle: ...`.
void printProblem(const QString& text);

} // namespace trundle
