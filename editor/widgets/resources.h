#pragma once
#include <QString>

namespace trundle {

/// Absolute path of a file in the resources folder: "icons/undo.svg". The folder is next to the installed program, else in the
/// source tree it was built from.
[[nodiscard]] QString resourcePath(const QString& below);

} // namespace trundle
