#include "editor/document/disk_watch.h"

#include <QDir>
#include <QFileInfo>

namespace trundle {

namespace {
constexpr int kCalmMs = 60; ///< delay after the last file system event before listeners are notified
}

DiskWatch::DiskWatch(QObject* parent) : QObject(parent) {
    m_calm.setSingleShot(true);
    m_calm.setInterval(kCalmMs);
    const auto sign = [this] { m_calm.start(); };
    connect(&m_watcher, &QFileSystemWatcher::fileChanged, this, sign);
    connect(&m_watcher, &QFileSystemWatcher::directoryChanged, this, sign);
    connect(&m_calm, &QTimer::timeout, this, [this] {
        addMissing(); // a replaced file is no longer watched: add it again
        Q_EMIT touched();
    });
}

void DiskWatch::watch(const std::vector<std::string>& files) {
    QStringList wanted;
    for (const std::string& file : files) {
        const QString path = QString::fromStdString(file);
        wanted += path;
        wanted += QFileInfo(path).path();
    }
    wanted.removeDuplicates();
    if (wanted == m_wanted) return;
    m_wanted = wanted;
    QStringList over = m_watcher.files() + m_watcher.directories();
    for (const QString& path : wanted) over.removeAll(path);
    if (!over.isEmpty()) m_watcher.removePaths(over);
    addMissing();
}

void DiskWatch::addMissing() {
    const QStringList watched = m_watcher.files() + m_watcher.directories();
    QStringList missing;
    for (const QString& path : std::as_const(m_wanted))
        if (!watched.contains(path) && QFileInfo::exists(path)) missing += path;
    if (!missing.isEmpty()) m_watcher.addPaths(missing);
}

} // namespace trundle
