#include "editor/text/code/code_pointer.h"

#include <QHelpEvent>
#include <QMouseEvent>

namespace trundle {

void CodePointer::rested(const QHelpEvent& event) { Q_EMIT hoverRequested(m_geometry.offsetAt(event.pos()), event.globalPos()); }

void CodePointer::moved(const QMouseEvent& event) {
    const bool looking = event.modifiers() == Qt::ControlModifier && event.buttons() == Qt::NoButton;
    if (looking || m_looking) Q_EMIT linkRequested(looking ? m_geometry.offsetAt(event.pos()) : CodeGeometry::kNowhere);
    m_looking = looking;
}

bool CodePointer::isOnLink(const QMouseEvent& press) const {
    return press.button() == Qt::LeftButton && press.modifiers() == Qt::ControlModifier &&
           m_geometry.offsetAt(press.pos()) != CodeGeometry::kNowhere;
}

void CodePointer::follow(const QMouseEvent& press) { Q_EMIT linkFollowed(m_geometry.offsetAt(press.pos())); }

} // namespace trundle
