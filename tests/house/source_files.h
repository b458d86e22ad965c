#pragma once
#include <QString>
#include <QStringList>

namespace trundle {

/// A file of the source tree, path from the root.
struct SourceFile {
    QString path;
    QString text;
};

/// Every readable text file below the given folders of the source tree (a name without a slash may be a file of the root), in the
/// order of their paths. Build folders and hidden ones are passed over. Empty `endings`: all.
[[nodiscard]] QList<SourceFile> sourceFiles(const QStringList& folders, const QStringList& endings);

} // namespace trundle
