#pragma once
#include <QString>

namespace trundle {

/// Absolute path of a file below the program's resources: "icons/undo.svg". Those of an installed program lie beside it, else
/// those of the source tree it was built from serve.
[[nodiscard]] QString resourcePath(const QString& below);

} // namespace trundle
