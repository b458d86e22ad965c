#pragma once
#include <string>
#include <vector>

#include <QFileSystemWatcher>
#include <QObject>
#include <QTimer>

namespace trundle {

/// Reports that one of the watched files may have changed on disk. The signal is delayed until the file system events stop,
/// so that a program that writes in several steps has finished. A file that is replaced by another of the same name stays
/// watched.
class DiskWatch final : public QObject {
    Q_OBJECT
public:
    explicit DiskWatch(QObject* parent = nullptr);
    void watch(const std::vector<std::string>& files); ///< replaces the previous list

Q_SIGNALS:
    void touched();

private:
    void addMissing();

    QStringList m_wanted; // files and the folders that contain them
    QFileSystemWatcher m_watcher;
    QTimer m_calm;
};

} // namespace trundle
