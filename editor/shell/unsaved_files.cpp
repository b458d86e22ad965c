#include "editor/shell/unsaved_files.h"

#include <QCoreApplication>
#include <QFileInfo>

namespace trundle {
namespace {

constexpr qsizetype kMaxInTitle = 3;

QString tr(const char* text, int count) { return QCoreApplication::translate("UnsavedFiles", text, nullptr, count); }

} // namespace

QStringList unsavedFiles(const Document& document) {
    QStringList names;
    if (!document.isOpen()) return names;
    for (const std::string& file : document.texts().modifiedFiles())
        names += QString::fromStdString(document.texts().shown(file));
    const QString opened = QString::fromStdString(document.texts().shown(document.path()));
    if (document.isNew() && !names.contains(opened)) names.prepend(opened);
    return names;
}

QString windowTitle(Document& document) {
    const QStringList unsaved = unsavedFiles(document);
    const QString opened = QString::fromStdString(document.texts().shown(document.path()));
    QString title = QFileInfo(opened).fileName();
    bool marked = unsaved.isEmpty() || unsaved.front() == opened;
    if (marked) title += QStringLiteral("[*]");
    QStringList others = unsaved;
    others.removeOne(opened);
    const QStringList named = others.size() > kMaxInTitle ? others.mid(0, kMaxInTitle - 1) : others;
    for (const QString& file : named) {
        title += QStringLiteral(", ") + QFileInfo(file).fileName() + (marked ? QStringLiteral("*") : QStringLiteral("[*]"));
        marked = true;
    }
    if (const auto more = int(others.size() - named.size()); more > 0)
        title += QLatin1Char(' ') + tr("and %1 more files*", more).arg(more);
    if (document.access().isReadOnly()) title += QStringLiteral(" – ") + QCoreApplication::translate("UnsavedFiles", "read-only");
    return title + QStringLiteral(" – Trundle");
}

} // namespace trundle
