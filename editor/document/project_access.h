#pragma once
#include <memory>
#include <string>

#include <QObject>

#include "base/result.h"
#include "project/journal/project_lock.h"

namespace trundle {

struct DocumentState;

/// Whether the open project can be edited here: one window per project.
class ProjectAccess final : public QObject {
    Q_OBJECT
public:
    explicit ProjectAccess(DocumentState& state) : m_state(state) {} ///< must outlive this object

    /// Another window has the project open: edits are refused until editAnyway().
    [[nodiscard]] bool isReadOnly() const { return m_readOnly; }
    [[nodiscard]] std::string readOnlyMessage() const;
    void editAnyway();
    /// Fails with the reason if nothing can be edited now. Tries again to lock a project that another window had open.
    [[nodiscard]] Status checkEditable();

    /// Locks the project that is open now, and releases the one before.
    void lock();
    void request();                       ///< tries again to lock a project that another window had open
    void forget() { m_readOnly = false; } ///< the file has another path now; lock() follows

Q_SIGNALS:
    void changed(const QString& holder); ///< describes the window that has the project; empty: editable

private:
    DocumentState& m_state;
    std::unique_ptr<ProjectLock> m_lock;
    bool m_readOnly = false;
};

} // namespace trundle
