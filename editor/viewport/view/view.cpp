#include "editor/viewport/view/view.h"

#include <QDropEvent>
#include <QKeyEvent>
#include <QPainter>

#include "editor/document/document.h"
#include "editor/document/selection.h"
#include "editor/viewport/context/view_settings.h"
#include "editor/viewport/context/viewport_scene.h"
#include "editor/viewport/overlays/overlays.h"
#include "editor/viewport/overlays/through_frame.h"
#include "editor/viewport/radio/radio_overlays.h"
#include "editor/widgets/theme.h"

namespace trundle {

View::View(const ViewContext& context, ViewKind kind, QWidget* parent)
    : QWidget(parent), m_context(context), m_camera(m_context, *this, kind), m_image(*this), m_drop(*this), m_tools(*this) {
    setObjectName(QStringLiteral("view3d"));
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setAcceptDrops(true);
    setAttribute(Qt::WA_OpaquePaintEvent);
    setMinimumSize(90, 90); // four of them beside the text fit in 800 pixels
    setAccessibleName(tr("3D view"));
    connectContext();
}

View::~View() = default;

void View::connectContext() {
    connect(&m_camera, &CameraControl::changed, this, &View::redraw);
    connect(&m_camera, &CameraControl::changed, this, [this] {
        if (m_hasMouse) m_tools.sceneMoved(m_cursor);
    });
    connect(&m_context.world, &ViewportScene::posed, this, [this] {
        if (m_hasMouse && !m_hints.hovered().empty()) m_tools.sceneMoved(m_cursor);
    });
    connect(&m_hints, &ViewHints::hoveredChanged, this, &View::redraw);
    connect(&m_hints, &ViewHints::textChanged, this, qOverload<>(&View::update));
    connect(&m_context.world, &ViewportScene::replaced, this, &View::redraw);
    connect(&m_context.world, &ViewportScene::posed, this, &View::redraw);
    connect(&m_context.world, &ViewportScene::marked, this, &View::redraw);
    connect(&m_context.world.dragged(), &DraggedObject::moved, this, &View::redraw);
    connect(&m_context.settings, &ViewSettings::changed, this, &View::redraw);
    connect(&m_context.settings, &ViewSettings::changed, this, qOverload<>(&View::update)); // handles need no new image
    connect(&m_context.selection, &Selection::changed, this, &View::redraw);
    if (const RadioOverlays* radios = m_context.radios) {
        connect(radios, &RadioOverlays::sceneChanged, this, &View::redraw);
        connect(radios, &RadioOverlays::linksChanged, this, qOverload<>(&QWidget::update));
    }
}

void View::frame(const Bounds& bounds, bool gently) {
    m_camera.frame(bounds, gently && isVisible() && !m_image.picture().isNull());
}

void View::endTool(const Pointer& pointer) {
    m_tools.end(pointer);
    m_image.settle();
}

void View::setCurrent(bool current, bool framed) {
    if (current == m_isCurrent && framed == m_isFramed) return;
    m_isCurrent = current;
    m_isFramed = framed;
    update();
}

void View::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    if (!m_image.paint(painter)) return;
    painter.setRenderHint(QPainter::Antialiasing);
    paintOverlays(painter, *this);
    paintThroughFrame(painter, *this);
    m_tools.paint(painter);
    m_hints.paint(painter, size(), m_cursor);
    m_drop.paint(painter);
    m_image.paintFailure(painter);
    if (m_isFramed) {
        painter.setPen(QPen(ink(Ink::Accent), 2));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(QRectF(rect()).adjusted(1, 1, -1, -1));
    }
}

void View::mousePressEvent(QMouseEvent* event) {
    Q_EMIT activated();
    m_cursor = event->position();
    m_camera.stop();
    m_image.cancelSettle();
    m_tools.press(*event);
}

void View::mouseDoubleClickEvent(QMouseEvent* event) { mousePressEvent(event); }

void View::mouseMoveEvent(QMouseEvent* event) {
    m_cursor = event->position();
    m_hasMouse = true;
    m_tools.move(*event);
}

void View::mouseReleaseEvent(QMouseEvent* event) { m_tools.release(*event); }

void View::wheelEvent(QWheelEvent* event) {
    m_tools.wheel(*event);
    event->accept();
}

void View::keyPressEvent(QKeyEvent* event) {
    if (m_tools.key(*event)) event->accept();
    else QWidget::keyPressEvent(event);
}

void View::keyReleaseEvent(QKeyEvent* event) {
    m_tools.keyReleased(*event);
    QWidget::keyReleaseEvent(event);
}

void View::focusInEvent(QFocusEvent* event) {
    Q_EMIT activated();
    QWidget::focusInEvent(event);
    update();
}

void View::focusOutEvent(QFocusEvent* event) {
    m_tools.focusLost();
    QWidget::focusOutEvent(event);
    update();
}

void View::leaveEvent(QEvent*) {
    m_hasMouse = false;
    m_tools.leave();
}

bool View::event(QEvent* event) {
    // While a tool is active its keys do not trigger shortcuts.
    if (event->type() == QEvent::ShortcutOverride) {
        const auto& key = static_cast<QKeyEvent&>(*event);
        const bool arrows = key.key() >= Qt::Key_Left && key.key() <= Qt::Key_Down;
        if (m_tools.needsKey(key) || arrows || key.key() == Qt::Key_Escape) {
            event->accept();
            return true;
        }
    }
    if (event->type() == QEvent::KeyPress) { // Tab would go to the next widget
        auto& key = static_cast<QKeyEvent&>(*event);
        if (key.key() == Qt::Key_Tab && m_tools.needsKey(key)) {
            keyPressEvent(&key);
            return true;
        }
    }
    return QWidget::event(event);
}

void View::resizeEvent(QResizeEvent*) { redraw(); }
void View::showEvent(QShowEvent*) { redraw(); }

void View::dragEnterEvent(QDragEnterEvent* event) { m_drop.enter(*event); }
void View::dragMoveEvent(QDragMoveEvent* event) { m_drop.move(*event); }
void View::dragLeaveEvent(QDragLeaveEvent*) { m_drop.leave(); }
void View::dropEvent(QDropEvent* event) { m_drop.drop(*event); }

} // namespace trundle
