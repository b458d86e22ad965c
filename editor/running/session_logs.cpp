// Where the logs of a run go, and what is said about them and about edits that do not reach the run.
#include "editor/running/session.h"

#include <filesystem>

#include <QFileInfo>
#include <QStandardPaths>

#include <trundle/abi.h>

#include "run/log_location.h"

namespace trundle {
namespace {

constexpr int kMostOwnLogs = 10'000;

} // namespace

/// Logs go where the command line puts them. Into the user's own folder go those of a sample that came with an installed program,
/// and may not be written beside it, of an experiment that is in no file yet, and of a window that only looks: the other one writes
/// them there.
LogLocation RunSession::logFolder() const {
    const std::string& project = m_document.loaded()->projectFolder;
    if (!m_document.isNew() && !m_document.isReadOnly() && QFileInfo(QString::fromStdString(project)).isWritable())
        return defaultLogs(project, m_document.path());
    if (!m_ownLogs.empty()) return m_ownLogs;
    const QString own = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation);
    return own.isEmpty() ? LogLocation() : defaultLogs(own.toStdString(), m_document.path());
}

/// Two windows may have experiments of one name that are in no file: each takes a folder that nobody has yet.
void RunSession::takeOwnLogs() {
    if (!m_ownLogs.empty() || (!m_document.isNew() && !m_document.isReadOnly())) return;
    const LogLocation first = logFolder();
    std::error_code failed;
    if (first.empty()) return;
    std::filesystem::create_directories(std::filesystem::path(first.path()).parent_path(), failed);
    for (int n = 1; n <= kMostOwnLogs; ++n) {
        const LogLocation own(first.folder, n == 1 ? first.below : first.below + "_" + std::to_string(n));
        if (!std::filesystem::create_directory(own.path(), failed)) continue;
        m_ownLogs = own;
        return;
    }
}

void RunSession::dropOwnLogs() {
    std::error_code hasLogs;
    if (!m_ownLogs.empty()) std::filesystem::remove(m_ownLogs.path(), hasLogs);
    m_ownLogs = {};
}

void RunSession::tellLogs() {
    if (const QString finish = finishText(); !finish.isEmpty()) tell(TRUNDLE_INFO, finish);
    else if (!m_end->failure) tell(TRUNDLE_INFO, tr("finished at t = %1 s").arg(m_end->time));
    QStringList files;
    for (const std::string& file : m_end->logFiles) files.append(QString::fromStdString(m_document.shown(file)));
    if (files.empty()) return;
    tell(TRUNDLE_INFO, tr("wrote %1").arg(files.join(QStringLiteral(", "))));
    setLogsAt(QString::fromStdString(logFolder().path())); // a controller may have opened one
}

QString RunSession::waitingText() const {
    constexpr std::size_t kMostNamed = 3;
    QStringList names;
    for (std::size_t i = 0; i < std::min(kMostNamed, m_waiting.size()); ++i) names += QString::fromStdString(m_waiting[i]);
    const QString text = names.join(QStringLiteral(", "));
    return m_waiting.size() <= kMostNamed ? text : tr("%1 and %2 more").arg(text, QString::number(m_waiting.size() - kMostNamed));
}

/// What runs on is not what the text says: said each time that it is set going.
void RunSession::sayWithoutEdits() {
    if (!needsReset()) return;
    const QString text = tr("Goes on without the edits of %1: Shift+F5, then F5, runs with them").arg(waitingText());
    tell(TRUNDLE_INFO, text);
    Q_EMIT m_document.notice(text);
}

} // namespace trundle
