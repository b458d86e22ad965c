#include "editor/document/project_access.h"

#include <utility>

#include "editor/document/document_state.h"

namespace trundle {

void ProjectAccess::lock() {
    m_lock.reset(); // release it before locking again: it may be the same project
    QString holder;
    if (m_state.isOpen() && !m_state.isNew() && !m_state.isSample(m_state.opened)) {
        m_lock = std::make_unique<ProjectLock>(m_state.loaded->projectFolder, m_state.opened);
        if (!m_lock->taken()) holder = QString::fromStdString(m_lock->holder().description());
    }
    const bool was = std::exchange(m_readOnly, !holder.isEmpty());
    if (was || m_readOnly) Q_EMIT changed(holder);
}

std::string ProjectAccess::readOnlyMessage() const {
    return "the project is open in " + m_lock->holder().description() + "; this window has it read-only";
}

void ProjectAccess::request() {
    if (!isReadOnly()) return;
    m_lock.reset();
    m_lock = std::make_unique<ProjectLock>(m_state.loaded->projectFolder, m_state.opened);
    if (!m_lock->taken()) return;
    editAnyway();
    Q_EMIT m_state.messages.notice(tr("The other window closed this project: it can be edited here now."));
}

void ProjectAccess::editAnyway() {
    if (!std::exchange(m_readOnly, false)) return;
    Q_EMIT changed({});
}

Status ProjectAccess::checkEditable() {
    if (!m_state.isOpen()) return Error{Code::NoDocument, "nothing is open"};
    if (m_state.reader.isOpening()) return Error{Code::NoDocument, "another file is being opened"};
    request();
    if (isReadOnly()) return Error{Code::FileUnwritable, readOnlyMessage()};
    return {};
}

} // namespace trundle
