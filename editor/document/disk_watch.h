#pragma once
#include <string>
#include <vector>

#include <QFileSystemWatcher>
#include <QObject>
#include <QTimer>

namespace trundle {

/// Says that one of some files may have changed on the disk: a moment after the last sign of it, so that a program that writes in
/// steps is done. A file that is replaced by another of its name goes on being watched.
class DiskWatch final : public QObject {
    Q_OBJECT
public:
    explicit DiskWatch(QObject* parent = nullptr);
    void watch(const std::vector<std::string>& files); ///< these and no others

Q_SIGNALS:
    void touched();

private:
    void addMissing();

    QStringList m_wanted; // files and their folders
    QFileSystemWatcher m_watcher;
    QTimer m_calm;
};

} // namespace trundle
