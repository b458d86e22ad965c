#include "editor/widgets/name_list.h"

#include <QCoreApplication>

namespace trundle {

QString listed(const QStringList& names, qsizetype most) {
    if (names.size() <= most) return names.join(QStringLiteral(", "));
    const auto more = int(names.size() - most);
    return names.mid(0, most).join(QStringLiteral(", ")) + QLatin1Char(' ') +
           QCoreApplication::translate("NameList", "and %1 more", nullptr, more).arg(more);
}

} // namespace trundle
