#pragma once
#include <QColor>
#include <QMap>
#include <QString>

namespace trundle {

/// The style sheet of the window; each `@name` is replaced by the colour of that name.
[[nodiscard]] QString styleSheet(const QMap<QString, QColor>& colours);

} // namespace trundle
