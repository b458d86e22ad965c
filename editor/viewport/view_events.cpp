// What a view does with events: the work that has the mouse comes first, then the others in their order.

#include <QDropEvent>
#include <QKeyEvent>
#include <QMimeData>
#include <QPainter>

#include "editor/viewport/library_drop.h"
#include "editor/viewport/navigation.h"
#include "editor/viewport/object_drop.h"
#include "editor/viewport/plate.h"
#include "editor/viewport/radio_overlays.h"
#include "editor/viewport/shown_world.h"
#include "editor/viewport/view.h"
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
    if (m_working) return; // one button at a time
    const Pointer pointer = pointerOf(*event);
    for (const auto& work : m_works) {
        if (!work->press(pointer)) continue;
        m_working = work.get();
        m_workButton = event->button();
        setHovered({}, {});
        return;
    }
}

void View::mouseDoubleClickEvent(QMouseEvent* event) { mousePressEvent(event); }

void View::mouseMoveEvent(QMouseEvent* event) {
    m_cursor = event->position();
    const Pointer pointer = pointerOf(*event);
    if (m_working && !event->buttons().testFlag(m_workButton)) endWork(pointer); // a dialog that came up got the release
    if (m_working) {
        m_working->drag(pointer);
        return;
    }
    bool taken = false;
    for (const auto& work : m_works) {
        if (taken) work->leave();
        else taken = work->hover(pointer);
    }
    if (!taken) setHovered({}, {});
    if (m_parts.radios && !m_parts.radios->nodes().empty()) update(); // the legend says more where the pointer is
}

void View::mouseReleaseEvent(QMouseEvent* event) {
    if (!m_working || event->button() != m_workButton) return;
    endWork(pointerOf(*event));
}

void View::wheelEvent(QWheelEvent* event) {
    m_navigation->wheel(event->position(),
                        event->angleDelta().y() != 0 ? event->angleDelta().y() : event->pixelDelta().y() * 4.0);
    event->accept();
}

void View::endWork(const Pointer& pointer) {
    if (MouseWork* done = std::exchange(m_working, nullptr)) done->release(pointer);
    settle();
}

void View::cancelWork() {
    if (!m_working) return;
    MouseWork* stopped = std::exchange(m_working, nullptr);
    stopped->cancel();
    update();
}

void View::keyPressEvent(QKeyEvent* event) {
    if (m_working && m_working->key(*event)) return event->accept();
    if (event->key() == Qt::Key_Escape && m_working) return cancelWork();
    if (event->key() == Qt::Key_Escape && !m_through.empty()) return lookThrough({});
    for (const auto& work : m_works)
        if (work.get() != m_working && work->key(*event)) return event->accept();
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
    if (m_working) return;
    for (const auto& work : m_works) work->leave();
    setHovered({}, {});
    if (m_parts.radios && !m_parts.radios->nodes().empty()) update();
}

bool View::event(QEvent* event) {
    // While something is dragged or flown its keys are not shortcuts.
    if (event->type() == QEvent::ShortcutOverride) {
        const auto& key = static_cast<QKeyEvent&>(*event);
        const bool arrows = key.key() >= Qt::Key_Left && key.key() <= Qt::Key_Down;
        if ((m_working && m_working->takesKeys()) || arrows || key.key() == Qt::Key_Escape) {
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
    m_dropping = takesDrop(*event);
    m_dropAt = event->position();
    if (m_dropping && !m_dropMoves) m_drop = std::make_unique<LibraryDrop>(*this, *event->mimeData(), true);
    if (m_drop) m_drop->hover(m_dropAt);
}

void View::dragMoveEvent(QDragMoveEvent* event) {
    if (!m_dropping) return;
    m_dropAt = event->position();
    m_dropping = takesDrop(*event);
    if (m_drop) m_drop->hover(m_dropAt);
    update();
}

/// Objects of this window are moved, with Ctrl copied; all else is a copy. The pointer shows which.
bool View::takesDrop(QDropEvent& event) const {
    if (!m_dropMoves && !canDrop(*event.mimeData())) return false;
    const bool copies = event.modifiers() & Qt::ControlModifier && !m_parts.world.isRunning();
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
    m_drop.reset(); // what it brings is read anew: it may have been another drag
    update();
    if (!takesDrop(*event)) return;
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
        // In a narrow view one below the other; all above the scale bar with its label, and where they would reach the axes
        // above these.
        const bool fits = metrics.horizontalAdvance(m_hint) + 20 < width();
        const QStringList lines = fits ? QStringList(m_hint) : m_hint.split(QStringLiteral(" · "));
        double wide = 0;
        for (const QString& line : lines) wide = std::max(wide, metrics.horizontalAdvance(line) + 14.0);
        const int scale = 34 + metrics.height(), axes = 0.5 * (width() - wide) < 76 ? 78 : 0;
        const double bottom = height() - std::max(scale, axes);
        for (int i = 0; i < lines.size(); ++i)
            paintPlate(painter, {0.5 * width(), bottom - high * (double(lines.size() - i) - 0.5)}, lines[i]);
    }
    if (!m_hoverHint.isEmpty()) {
        const double half = 0.5 * (metrics.horizontalAdvance(m_hoverHint) + 14);
        const double x = std::clamp(m_cursor.x() + 14 + half, half + 2, std::max(half + 2, width() - half - 2));
        const bool below = m_cursor.y() + 16 + high < height() - 2;
        paintPlate(painter, {x, below ? m_cursor.y() + 16 + 0.5 * high : m_cursor.y() - 8 - 0.5 * high}, m_hoverHint);
    }
    if (m_dropping) {
        painter.setPen(QPen(ink(Ink::Accent), 2));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(QRectF(rect()).adjusted(1, 1, -1, -1));
        const auto at = m_parts.world.dragged() ? std::nullopt : pixelOf(pointUnder(m_dropAt));
        if (at) painter.drawEllipse(*at, 9, 5);
    }
}

} // namespace trundle
