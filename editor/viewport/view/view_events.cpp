// Event handling of a view: the active tool gets the events first, then the other tools in order.

#include <QDropEvent>
#include <QKeyEvent>
#include <QMimeData>
#include <QPainter>

#include "editor/viewport/context/label.h"
#include "editor/viewport/context/viewport_scene.h"
#include "editor/viewport/radio/radio_overlays.h"
#include "editor/viewport/tools/library_drop.h"
#include "editor/viewport/tools/navigation.h"
#include "editor/viewport/tools/object_drop.h"
#include "editor/viewport/view/view.h"
#include "editor/widgets/theme.h"

namespace trundle {

Pointer View::pointerOf(const QMouseEvent& event) const {
    return {event.position(), event.button(), event.modifiers(), event.type() == QEvent::MouseButtonDblClick};
}

void View::mousePressEvent(QMouseEvent* event) {
    Q_EMIT activated();
    m_cursor = event->position();
    m_glide.stop();
    m_settle.stop();
    if (m_activeTool) return; // further buttons are ignored during a drag
    const Pointer pointer = pointerOf(*event);
    for (const auto& work : m_tools) {
        if (!work->press(pointer)) continue;
        m_activeTool = work.get();
        m_workButton = event->button();
        setHovered({}, {});
        return;
    }
}

void View::mouseDoubleClickEvent(QMouseEvent* event) { mousePressEvent(event); }

void View::mouseMoveEvent(QMouseEvent* event) {
    m_cursor = event->position();
    const Pointer pointer = pointerOf(*event);
    if (m_activeTool && !event->buttons().testFlag(m_workButton)) endTool(pointer); // a dialog received the release
    if (m_activeTool) {
        m_activeTool->drag(pointer);
        return;
    }
    bool taken = false;
    for (const auto& work : m_tools) {
        if (taken) work->leave();
        else taken = work->hover(pointer);
    }
    if (!taken) setHovered({}, {});
    if (m_context.radios && !m_context.radios->nodes().empty()) update(); // the legend shows more under the pointer
}

void View::mouseReleaseEvent(QMouseEvent* event) {
    if (!m_activeTool || event->button() != m_workButton) return;
    endTool(pointerOf(*event));
}

void View::wheelEvent(QWheelEvent* event) {
    m_navigation->wheel(event->position(),
                        event->angleDelta().y() != 0 ? event->angleDelta().y() : event->pixelDelta().y() * 4.0);
    event->accept();
}

void View::endTool(const Pointer& pointer) {
    if (ViewTool* done = std::exchange(m_activeTool, nullptr)) done->release(pointer);
    settle();
}

void View::cancelTool() {
    if (!m_activeTool) return;
    ViewTool* stopped = std::exchange(m_activeTool, nullptr);
    stopped->cancel();
    update();
}

void View::keyPressEvent(QKeyEvent* event) {
    if (m_activeTool && m_activeTool->key(*event)) return event->accept();
    if (event->key() == Qt::Key_Escape && m_activeTool) return cancelTool();
    if (event->key() == Qt::Key_Escape && !m_through.empty()) return lookThrough({});
    for (const auto& work : m_tools)
        if (work.get() != m_activeTool && work->key(*event)) return event->accept();
    QWidget::keyPressEvent(event);
}

void View::keyReleaseEvent(QKeyEvent* event) {
    if (!event->isAutoRepeat()) m_navigation->keyReleased(event->key());
    QWidget::keyReleaseEvent(event);
}

void View::focusInEvent(QFocusEvent* event) {
    Q_EMIT activated();
    QWidget::focusInEvent(event);
    update();
}

void View::focusOutEvent(QFocusEvent* event) {
    m_navigation->stopFlying();
    QWidget::focusOutEvent(event);
    update();
}

void View::leaveEvent(QEvent*) {
    if (m_activeTool) return;
    for (const auto& work : m_tools) work->leave();
    setHovered({}, {});
    if (m_context.radios && !m_context.radios->nodes().empty()) update();
}

bool View::event(QEvent* event) {
    // While a tool is active its keys do not trigger shortcuts.
    if (event->type() == QEvent::ShortcutOverride) {
        const auto& key = static_cast<QKeyEvent&>(*event);
        const bool arrows = key.key() >= Qt::Key_Left && key.key() <= Qt::Key_Down;
        if ((m_activeTool && m_activeTool->canHandleKeys()) || arrows || key.key() == Qt::Key_Escape) {
            event->accept();
            return true;
        }
    }
    return QWidget::event(event);
}

void View::resizeEvent(QResizeEvent*) { redraw(); }

void View::showEvent(QShowEvent*) { redraw(); }

void View::dragEnterEvent(QDragEnterEvent* event) {
    m_dropMoves = canMoveHere(*this, *event->mimeData());
    m_dropping = acceptsDrop(*event);
    m_dropAt = event->position();
    if (m_dropping && !m_dropMoves) m_drop = std::make_unique<LibraryDrop>(*this, *event->mimeData(), true);
    if (m_drop) m_drop->hover(m_dropAt);
}

void View::dragMoveEvent(QDragMoveEvent* event) {
    if (!m_dropping) return;
    m_dropAt = event->position();
    m_dropping = acceptsDrop(*event);
    if (m_drop) m_drop->hover(m_dropAt);
    update();
}

/// Objects of this window are moved, or copied with Ctrl; everything else is copied. Sets the cursor accordingly.
bool View::acceptsDrop(QDropEvent& event) const {
    if (!m_dropMoves && !canDrop(*event.mimeData())) return false;
    const bool copies = event.modifiers() & Qt::ControlModifier && !m_context.world.isRunning();
    event.setDropAction(m_dropMoves && !copies ? Qt::MoveAction : Qt::CopyAction);
    event.accept();
    return true;
}

void View::dragLeaveEvent(QDragLeaveEvent*) {
    m_dropping = false;
    m_drop.reset();
    update();
}

void View::dropEvent(QDropEvent* event) {
    m_dropping = false;
    m_drop.reset(); // recreated from this event, since its data may differ
    update();
    if (!acceptsDrop(*event)) return;
    if (event->dropAction() == Qt::MoveAction) moveHere(*this, event->position());
    else if (m_dropMoves) copyHere(*this, event->position());
    else LibraryDrop(*this, *event->mimeData(), false).drop(event->position());
}

void View::paintMessage(QPainter& painter, const QString& text) const {
    const QRect box =
        painter.fontMetrics().boundingRect(rect().adjusted(24, 0, -24, 0), Qt::AlignCenter | Qt::TextWordWrap, text);
    painter.setPen(Qt::NoPen);
    painter.setBrush(palette().color(QPalette::Base));
    painter.drawRoundedRect(box.adjusted(-12, -8, 12, 8), 6, 6);
    painter.setPen(ink(Ink::Text));
    painter.drawText(box, Qt::AlignCenter | Qt::TextWordWrap, text);
}

void View::paintHints(QPainter& painter) const {
    const QFontMetrics metrics = painter.fontMetrics();
    const double high = metrics.height() + 6;
    if (!m_hint.isEmpty()) {
        // In a narrow view the hint is split into several lines. It is placed above the scale bar and its label, and above the
        // axes where it would overlap them.
        const bool fits = metrics.horizontalAdvance(m_hint) + 20 < width();
        const QStringList lines = fits ? QStringList(m_hint) : m_hint.split(QStringLiteral(" · "));
        double wide = 0;
        for (const QString& line : lines) wide = std::max(wide, metrics.horizontalAdvance(line) + 14.0);
        const int scale = 34 + metrics.height(), axes = 0.5 * (width() - wide) < 76 ? 78 : 0;
        const double bottom = height() - std::max(scale, axes);
        for (int i = 0; i < lines.size(); ++i)
            paintLabel(painter, {0.5 * width(), bottom - high * (double(lines.size() - i) - 0.5)}, lines[i]);
    }
    if (!m_hoverHint.isEmpty()) {
        const double half = 0.5 * (metrics.horizontalAdvance(m_hoverHint) + 14);
        const double x = std::clamp(m_cursor.x() + 14 + half, half + 2, std::max(half + 2, width() - half - 2));
        const bool below = m_cursor.y() + 16 + high < height() - 2;
        paintLabel(painter, {x, below ? m_cursor.y() + 16 + 0.5 * high : m_cursor.y() - 8 - 0.5 * high}, m_hoverHint);
    }
    if (m_dropping) {
        painter.setPen(QPen(ink(Ink::Accent), 2));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(QRectF(rect()).adjusted(1, 1, -1, -1));
        const auto at = m_context.world.dragged() ? std::nullopt : pixelOf(pointUnder(m_dropAt));
        if (at) painter.drawEllipse(*at, 9, 5);
    }
}

} // namespace trundle
