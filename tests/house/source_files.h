#pragma once
#include <QString>
#include <QStringList>

namespace trundle {

/// A file of the source tree; its path is relative to the root.
struct SourceFile {
    QString path;
    QString text;
};

/// Every readable text file below the given folders of the source tree (a name without a slash may be a file of the root), sorted
/// by path. Build folders and hidden folders are skipped. Empty `endings`: all files.
[[nodiscard]] QList<SourceFile> sourceFiles(const QStringList& folders, const QStringList& endings);

} // namespace trundle
