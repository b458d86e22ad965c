#include "editor/widgets/resources.h"

#include <QCoreApplication>
#include <QDir>

namespace trundle {

QString resourcePath(const QString& below) {
    static const QString folder = [] {
        const QDir installed(QCoreApplication::applicationDirPath() + QStringLiteral("/../share/trundle/resources"));
        return installed.exists() ? installed.canonicalPath() : QStringLiteral(TRUNDLE_SOURCE_RESOURCES);
    }();
    return folder + QLatin1Char('/') + below;
}

} // namespace trundle
