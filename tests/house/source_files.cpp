#include "house/source_files.h"

#include <QDir>
#include <QDirIterator>
#include <QFile>

#include <algorithm>

namespace trundle {
namespace {

bool wanted(const QString& path, const QStringList& endings) {
    if (path.contains("/build/") || path.contains("/__pycache__/")) return false;
    if (endings.isEmpty()) return true;
    return std::any_of(endings.begin(), endings.end(), [&](const QString& ending) { return path.endsWith(ending); });
}

} // namespace

QList<SourceFile> sourceFiles(const QStringList& folders, const QStringList& endings) {
    const QDir root(TRUNDLE_SOURCE_DIR);
    QStringList paths;
    for (const QString& folder : folders) {
        const QString at = root.filePath(folder);
        if (QFileInfo(at).isFile()) paths << at;
        QDirIterator files(at, QDir::Files | QDir::NoSymLinks, QDirIterator::Subdirectories);
        while (files.hasNext()) paths << files.next();
    }
    std::sort(paths.begin(), paths.end());
    QList<SourceFile> found;
    for (const QString& path : paths) {
        QFile file(path);
        if (!wanted(path, endings) || !file.open(QIODevice::ReadOnly) || file.size() > 1'000'000) continue;
        found.append({root.relativeFilePath(path), QString::fromUtf8(file.readAll())});
    }
    return found;
}

} // namespace trundle
