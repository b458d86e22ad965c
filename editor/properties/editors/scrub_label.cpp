#include "editor/properties/editors/scrub_label.h"

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>

namespace trundle {

namespace {
constexpr double kPixelsPerStep = 3;
}

ScrubLabel::ScrubLabel(QWidget* parent) : QLabel(parent) {}

void ScrubLabel::setScrubbing(bool on) {
    m_on = on;
    if (on) setCursor(Qt::SizeHorCursor);
    else unsetCursor();
}

void ScrubLabel::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return QLabel::mousePressEvent(event);
    m_down = true;
    m_moved = false;
    m_steps = 0;
    m_last = event->position();
}

void ScrubLabel::mouseMoveEvent(QMouseEvent* event) {
    if (!m_down || !m_on) return;
    const double way = event->position().x() - m_last.x();
    if (!m_moved && std::abs(way) < QApplication::startDragDistance() / 2.0) return;
    if (!m_moved) grabKeyboard(); // to receive Esc
    m_moved = true;
    m_last = event->position();
    const double factor = event->modifiers() & Qt::ShiftModifier ? 0.2 : event->modifiers() & Qt::ControlModifier ? 10 : 1;
    const double before = std::round(m_steps);
    m_steps += way / kPixelsPerStep * factor;
    if (std::round(m_steps) != before) Q_EMIT dragged(m_steps);
}

void ScrubLabel::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || !m_down) return;
    m_down = false;
    if (!m_moved) {
        Q_EMIT clicked();
        return;
    }
    releaseKeyboard();
    Q_EMIT ended();
}

void ScrubLabel::keyPressEvent(QKeyEvent* event) {
    if (!m_down || event->key() != Qt::Key_Escape) return QLabel::keyPressEvent(event);
    m_down = false;
    releaseKeyboard();
    Q_EMIT cancelled();
}

} // namespace trundle
