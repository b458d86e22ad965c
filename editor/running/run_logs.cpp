#include "editor/running/run_logs.h"

#include <filesystem>

#include <QFileInfo>
#include <QStandardPaths>

namespace trundle {
namespace {

constexpr int kMaxOwnLogs = 10'000;

} // namespace

RunLogs::RunLogs(Document& document, QObject* parent) : QObject(parent), m_document(document) {}

RunLogs::~RunLogs() { dropOwn(); }

LogLocation RunLogs::begin(bool hasLogs) {
    takeOwn();
    const LogLocation here = location();
    setFolder(hasLogs ? QString::fromStdString(here.path()) : QString());
    return here;
}

void RunLogs::written() { setFolder(QString::fromStdString(location().path())); }

void RunLogs::forget() {
    dropOwn();
    setFolder({});
}

/// Logs are written where trundle-cli would write them. The user's own folder is used for installed samples, whose folder is not
/// writable, for experiments not saved yet, and for read-only windows, since another window writes the project's logs.
LogLocation RunLogs::location() const {
    const std::string& project = m_document.loaded()->projectFolder;
    if (!m_document.isNew() && !m_document.access().isReadOnly() && QFileInfo(QString::fromStdString(project)).isWritable())
        return logsOf(project, m_document.path());
    if (!m_own.empty()) return m_own;
    const QString own = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation);
    return own.isEmpty() ? LogLocation() : logsOf(own.toStdString(), m_document.path());
}

/// Two windows may have unsaved experiments of the same name: each takes a folder that does not exist yet.
void RunLogs::takeOwn() {
    if (!m_own.empty() || (!m_document.isNew() && !m_document.access().isReadOnly())) return;
    const LogLocation first = location();
    std::error_code failed;
    if (first.empty()) return;
    std::filesystem::create_directories(std::filesystem::path(first.path()).parent_path(), failed);
    for (int n = 1; n <= kMaxOwnLogs; ++n) {
        LogLocation own = first;
        if (n > 1) own.below += "_" + std::to_string(n);
        if (!std::filesystem::create_directory(own.path(), failed)) continue;
        m_own = own;
        return;
    }
}

void RunLogs::dropOwn() {
    std::error_code hasLogs;
    if (!m_own.empty()) std::filesystem::remove(m_own.path(), hasLogs);
    m_own = {};
}

void RunLogs::setFolder(const QString& folder) {
    if (folder == m_folder) return;
    m_folder = folder;
    Q_EMIT folderChanged();
}

} // namespace trundle
