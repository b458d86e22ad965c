#pragma once
#include <QColor>
#include <QMap>
#include <QString>

namespace trundle {

/// The style sheet of the window with `@name` replaced by colours.
[[nodiscard]] QString styleSheet(const QMap<QString, QColor>& colours);

} // namespace trundle
