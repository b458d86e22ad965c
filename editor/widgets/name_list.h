#pragma once
#include <QString>
#include <QStringList>

namespace trundle {

/// "a.sim, b.sim and 3 more": the first names and the number of the others.
[[nodiscard]] QString listed(const QStringList& names, qsizetype most);

} // namespace trundle
