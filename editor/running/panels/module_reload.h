#pragma once
#include <map>

#include <QDateTime>
#include <QFileSystemWatcher>
#include <QObject>
#include <QTimer>

#include "editor/running/session.h"

class QAction;

namespace trundle {

/// The libraries of a run in progress with controllers in processes of their own; without one it is empty.
[[nodiscard]] QStringList hostedModules(const RunSession& session);

/// Reloads the modules of a run when they are rebuilt, while `follow` is checked. A file is taken once it is complete and has not
/// changed between two looks.
class ModuleReload final : public QObject {
    Q_OBJECT
public:
    ModuleReload(RunSession& session, QAction& follow, QObject* parent = nullptr);

private:
    struct Stamp {
        QDateTime modified;
        qint64 bytes = -1;
        bool operator==(const Stamp&) const = default;
    };
    struct Library {
        Stamp loaded, seen;
    };
    void begin();
    void look();
    [[nodiscard]] static Stamp stampOf(const QString& library);
    void watch(const QString& library);

    RunSession& m_session;
    QAction& m_follow;
    QFileSystemWatcher m_watcher;
    QTimer m_settle;
    std::map<QString, Library> m_libraries;
};

} // namespace trundle
