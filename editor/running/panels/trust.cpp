#include "editor/running/panels/trust.h"

#include <QDir>
#include <QFileInfo>
#include <QSettings>

namespace trundle {
namespace {

const QString kKey = QStringLiteral("trustedFolders");

/// The canonical path, so that each folder has one name.
QString realPath(const QString& folder) {
    const QString canonical = QFileInfo(folder).canonicalFilePath();
    return canonical.isEmpty() ? QDir::cleanPath(QDir(folder).absolutePath()) : canonical;
}

} // namespace

QStringList TrustedFolders::all() { return QSettings().value(kKey).toStringList(); }

bool TrustedFolders::covers(const QString& folder) {
    const QString real = realPath(folder);
    for (const QString& trusted : all()) {
        const QString above = realPath(trusted);
        if (real == above || real.startsWith(above.endsWith(u'/') ? above : above + u'/')) return true;
    }
    return false;
}

void TrustedFolders::add(const QString& folder) {
    if (covers(folder)) return;
    QStringList folders = all();
    folders.append(realPath(folder));
    QSettings().setValue(kKey, folders);
}

void TrustedFolders::remove(const QString& folder) {
    QStringList folders = all();
    folders.removeAll(realPath(folder));
    folders.removeAll(folder);
    QSettings().setValue(kKey, folders);
}

} // namespace trundle
