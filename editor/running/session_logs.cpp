// RunSession: log folders, and messages about logs and about edits that do not reach the run.
#include "editor/running/session.h"

#include <filesystem>

#include <QFileInfo>
#include <QStandardPaths>

#include <trundle/abi.h>

#include "run/log_location.h"

namespace trundle {
namespace {

constexpr int kMaxOwnLogs = 10'000;

} // namespace

/// Logs are written where trundle-cli would write them. The user's own folder is used for installed samples, whose folder is not
/// writable, for experiments not saved yet, and for read-only windows, since another window writes the project's logs.
LogLocation RunSession::logFolder() const {
    const std::string& project = m_document.loaded()->projectFolder;
    if (!m_document.isNew() && !m_document.isReadOnly() && QFileInfo(QString::fromStdString(project)).isWritable())
        return defaultLogs(project, m_document.path());
    if (!m_ownLogs.empty()) return m_ownLogs;
    const QString own = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation);
    return own.isEmpty() ? LogLocation() : defaultLogs(own.toStdString(), m_document.path());
}

/// Two windows may have unsaved experiments of the same name: each takes a folder that does not exist yet.
void RunSession::takeOwnLogs() {
    if (!m_ownLogs.empty() || (!m_document.isNew() && !m_document.isReadOnly())) return;
    const LogLocation first = logFolder();
    std::error_code failed;
    if (first.empty()) return;
    std::filesystem::create_directories(std::filesystem::path(first.path()).parent_path(), failed);
    for (int n = 1; n <= kMaxOwnLogs; ++n) {
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

void RunSession::reportLogs() {
    if (const QString finish = finishText(); !finish.isEmpty()) addConsoleLine(TRUNDLE_INFO, finish);
    else if (!m_end->failure) addConsoleLine(TRUNDLE_INFO, tr("finished at t = %1 s").arg(m_end->time));
    QStringList files;
    for (const std::string& file : m_end->logFiles) files.append(QString::fromStdString(m_document.shown(file)));
    if (files.empty()) return;
    addConsoleLine(TRUNDLE_INFO, tr("wrote %1").arg(files.join(QStringLiteral(", "))));
    setLogsAt(QString::fromStdString(logFolder().path())); // a controller may have opened the first log
}

QString RunSession::waitingText() const {
    constexpr std::size_t kMaxNamed = 3;
    QStringList names;
    for (std::size_t i = 0; i < std::min(kMaxNamed, m_waiting.size()); ++i) names += QString::fromStdString(m_waiting[i]);
    const QString text = names.join(QStringLiteral(", "));
    return m_waiting.size() <= kMaxNamed ? text : tr("%1 and %2 more").arg(text, QString::number(m_waiting.size() - kMaxNamed));
}

/// Reports, each time the run is resumed, that it does not include the edits since it was built.
void RunSession::reportWaitingEdits() {
    if (!needsReset()) return;
    const QString text = tr("Continues without the edits of %1: Shift+F5, then F5, runs with them").arg(waitingText());
    addConsoleLine(TRUNDLE_INFO, text);
    Q_EMIT m_document.notice(text);
}

} // namespace trundle
