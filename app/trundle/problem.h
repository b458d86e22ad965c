#pragma once
#include <QString>

namespace trundle {

/// `text` without what a terminal would obey or show as something else.
[[nodiscard]] QString forTerminal(const QString& text);
/// One line on standard error, `trundle: ...`.
void printProblem(const QString& text);

} // namespace trundle
