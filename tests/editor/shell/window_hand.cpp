#include "editor/shell/window_hand.h"

#include <QAbstractButton>
#include <QApplication>
#include <QDropEvent>
#include <QFileDialog>
#include <QLineEdit>
#include <QListView>
#include <QMenu>
#include <QMenuBar>
#include <QMimeData>
#include <QScrollArea>
#include <QTimer>
#include <QtTest>

#include "editor/outline/outline_model.h"
#include "editor/outline/outline_view.h"
#include "editor/shell/main_window.h"
#include "editor/viewport/view/viewport_panel.h"

namespace trundle {
namespace {

QString plain(QString text) { return text.remove(QLatin1Char('&')).remove(QStringLiteral("…")); }

QAction* entryOf(const QWidget& menu, const QString& text) {
    for (QAction* action : menu.actions())
        if (plain(action->text()) == text && action->isVisible() && action->isEnabled()) return action;
    return nullptr;
}

View& viewOf(MainWindow& window) { return window.viewport().views().current(); }

} // namespace

bool WindowHand::choose(const QStringList& entries) const {
    QMenuBar& bar = *m_window.menuBar();
    QAction* action = entryOf(bar, entries.front());
    if (!action) return false;
    QTest::mouseClick(&bar, Qt::LeftButton, {}, bar.actionGeometry(action).center());
    QMenu* menu = action->menu();
    for (const QString& entry : entries.mid(1)) {
        action = menu ? entryOf(*menu, entry) : nullptr;
        if (!action) {
            while (QWidget* popup = QApplication::activePopupWidget()) popup->close();
            return false;
        }
        QTest::mouseMove(menu, menu->actionGeometry(action).center());
        QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(action).center());
        menu = action->menu();
    }
    return true;
}

bool WindowHand::press(const char* button) const {
    auto* widget = m_window.findChild<QAbstractButton*>(QLatin1String(button));
    if (!widget || !widget->isVisible() || !widget->isEnabled()) return false;
    QTest::mouseClick(widget, Qt::LeftButton);
    return true;
}

bool WindowHand::clickRow(const std::string& path) const {
    auto* tree = m_window.findChild<OutlineView*>();
    auto* model = qobject_cast<OutlineModel*>(tree->model());
    const QModelIndex index = model->indexOf(path);
    if (!index.isValid()) return false;
    tree->reveal(index);
    tree->scrollTo(index);
    QTest::mouseClick(tree->viewport(), Qt::LeftButton, {}, tree->visualRect(index).center());
    return true;
}

void WindowHand::key(int key, Qt::KeyboardModifiers modifiers) const {
    QWidget* focus = QApplication::focusWidget();
    QTest::keyClick(focus ? focus : &m_window, static_cast<Qt::Key>(key), modifiers);
}

void WindowHand::keyDown(int key) const { QTest::keyPress(QApplication::focusWidget(), static_cast<Qt::Key>(key)); }
void WindowHand::keyUp(int key) const { QTest::keyRelease(QApplication::focusWidget(), static_cast<Qt::Key>(key)); }

void WindowHand::look(const Vec3& eye, const Vec3& target) const {
    CameraView camera = viewOf(m_window).camera().free().view();
    camera.eye = eye;
    camera.target = target;
    viewOf(m_window).camera().setView(camera);
}

void WindowHand::clickPoint(const Vec3& point) const {
    View& view = viewOf(m_window);
    if (const auto at = view.camera().pixelOf(point)) QTest::mouseClick(&view, Qt::LeftButton, {}, at->toPoint());
}

QPointF WindowHand::pixelOf(const Vec3& point) const {
    return viewOf(m_window).camera().pixelOf(point).value_or(QPointF(-1, -1));
}

void WindowHand::dragPixels(const QPointF& from, const QPointF& to) const {
    constexpr int kSteps = 6;
    View& view = viewOf(m_window);
    QTest::mouseMove(&view, from.toPoint());
    QTest::mousePress(&view, Qt::LeftButton, {}, from.toPoint());
    for (int i = 1; i <= kSteps; ++i) QTest::mouseMove(&view, (from + i * (to - from) / kSteps).toPoint());
    QTest::mouseRelease(&view, Qt::LeftButton, {}, to.toPoint());
}

void WindowHand::dragPoints(const Vec3& from, const Vec3& to) const { dragPixels(pixelOf(from), pixelOf(to)); }

void WindowHand::typeOver(QWidget* line, const QString& text) {
    line->setFocus();
    QTest::keyClick(line, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(line, text);
}

/// A timer looks for the dialog, since its event loop runs before what opens it returns; that loop may also begin later.
void WindowHand::answerFileDialog(const QString& path) const {
    auto* timer = new QTimer(&m_window);
    QObject::connect(timer, &QTimer::timeout, timer, [timer, path] {
        auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
        auto* line = dialog ? dialog->findChild<QLineEdit*>(QStringLiteral("fileNameEdit")) : nullptr;
        if (!line) return;
        timer->stop();
        timer->deleteLater();
        typeOver(line, path);
        // As for a person, what completes the name takes the first one.
        for (int i = 0; i < 2 && dialog->isVisible(); ++i) QTest::keyClick(line, Qt::Key_Return);
        if (dialog->isVisible()) dialog->reject(); // so that the test fails instead of waiting
    });
    timer->start(20);
}

bool WindowHand::dragToPoint(const QString& item, const Vec3& point) const {
    View& view = viewOf(m_window);
    const auto at = view.camera().pixelOf(point);
    if (!at) return false;
    for (QListView* list : m_window.findChildren<QListView*>()) {
        if (!list->objectName().startsWith(QStringLiteral("libraryList.")) || !list->isVisible()) continue;
        for (int row = 0; row < list->model()->rowCount(); ++row) {
            const QModelIndex index = list->model()->index(row, 0);
            if (index.data().toString() != item) continue;
            if (auto* area = m_window.findChild<QScrollArea*>(QStringLiteral("libraryArea"))) {
                const QPoint middle = list->mapTo(area->widget(), list->visualRect(index).center());
                area->ensureVisible(middle.x(), middle.y());
            }
            // What Qt sends to the view for the drag: QDrag::exec() would wait for a mouse that a test cannot move meanwhile.
            const std::unique_ptr<QMimeData> mime(list->model()->mimeData({index}));
            const QPoint to = at->toPoint();
            QDragEnterEvent enter(to, Qt::CopyAction, mime.get(), Qt::LeftButton, {});
            QCoreApplication::sendEvent(&view, &enter);
            QDragMoveEvent move(to, Qt::CopyAction, mime.get(), Qt::LeftButton, {});
            QCoreApplication::sendEvent(&view, &move);
            QDropEvent drop(to, Qt::CopyAction, mime.get(), Qt::LeftButton, {});
            QCoreApplication::sendEvent(&view, &drop);
            if (!drop.isAccepted()) return false;
            return true;
        }
    }
    return false;
}

} // namespace trundle
