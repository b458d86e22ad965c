#include "editor/shell/dialogs/crash_reports.h"

#include <QDateTime>
#include <QDir>
#include <QLocale>

#include "base/platform/read_file.h"
#include "editor/widgets/plain_text.h"

namespace trundle {

QString takeCrashReports(const QString& folder) {
    constexpr std::size_t kLongest = 16 << 10; // bytes
    constexpr qsizetype kMost = 5;
    QStringList lines;
    const QFileInfoList files =
        QDir(folder).entryInfoList({QStringLiteral("*.txt")}, QDir::Files | QDir::NoSymLinks, QDir::Time | QDir::Reversed);
    for (const QFileInfo& file : files) {
        const Result<std::string> text = readRegularFile(file.filePath().toStdString(), kLongest);
        const QString when = QLocale().toString(file.lastModified(), QLocale::ShortFormat); // before it is removed
        if (!QFile::remove(file.filePath()) || !text) continue; // a file that stays would be reported at each start
        lines += when + QStringLiteral(": ") + shownLine(text.value().substr(0, text.value().find('\n')));
    }
    return lines.mid(std::max(qsizetype(0), lines.size() - kMost)).join(QStringLiteral("\n\n"));
}

} // namespace trundle
