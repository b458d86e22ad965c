#include "editor/viewport/view/view_drop.h"

#include <QDropEvent>
#include <QMimeData>
#include <QPainter>
#include <QWidget>

#include "editor/viewport/context/tool_view.h"
#include "editor/viewport/context/viewport_scene.h"
#include "editor/viewport/tools/library_drop.h"
#include "editor/viewport/tools/object_drop.h"
#include "editor/widgets/theme.h"

namespace trundle {

ViewDrop::ViewDrop(ToolView& view) : m_view(view) {}
ViewDrop::~ViewDrop() = default;

void ViewDrop::enter(QDragEnterEvent& event) {
    m_moves = canMoveHere(m_view, *event.mimeData());
    m_dropping = accepts(event);
    m_at = event.position();
    if (m_dropping && !m_moves) m_library = std::make_unique<LibraryDrop>(m_view, *event.mimeData(), true);
    if (m_library) m_library->hover(m_at);
}

void ViewDrop::move(QDragMoveEvent& event) {
    if (!m_dropping) return;
    m_at = event.position();
    m_dropping = accepts(event);
    if (m_library) m_library->hover(m_at);
    m_view.widget().update();
}

/// Objects of this window are moved, or copied with Ctrl; everything else is copied. Sets the cursor accordingly.
bool ViewDrop::accepts(QDropEvent& event) const {
    if (!m_moves && !canDrop(*event.mimeData())) return false;
    const bool copies = event.modifiers() & Qt::ControlModifier && !m_view.context().world.isRunning();
    event.setDropAction(m_moves && !copies ? Qt::MoveAction : Qt::CopyAction);
    event.accept();
    return true;
}

void ViewDrop::leave() {
    m_dropping = false;
    m_library.reset();
    m_view.widget().update();
}

void ViewDrop::drop(QDropEvent& event) {
    leave(); // the object is made again from this event, since its data may differ
    if (!accepts(event)) return;
    if (event.dropAction() == Qt::MoveAction) moveHere(m_view, event.position());
    else if (m_moves) copyHere(m_view, event.position());
    else LibraryDrop(m_view, *event.mimeData(), false).drop(event.position());
}

void ViewDrop::paint(QPainter& painter) const {
    if (!m_dropping) return;
    painter.setPen(QPen(ink(Ink::Accent), 2));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(QRectF(m_view.widget().rect()).adjusted(1, 1, -1, -1));
    const CameraControl& camera = m_view.camera();
    if (m_library) m_library->paintGuides(painter);
    const Vec3 spot = m_library && m_library->spot() ? *m_library->spot() : camera.pointUnder(m_at);
    const auto at = m_view.context().world.dragged().pose() ? std::nullopt : camera.pixelOf(spot);
    if (at) painter.drawEllipse(*at, 9, 5);
}

} // namespace trundle
