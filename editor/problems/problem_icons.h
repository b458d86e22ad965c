#pragma once
#include <QIcon>
#include <QString>

#include "base/diagnostic.h"

namespace trundle {

/// A cross, a triangle or a dot in the current theme's colours.
[[nodiscard]] QIcon severityIcon(Severity severity);
[[nodiscard]] QString severityWord(Severity severity);

} // namespace trundle
