#include "editor/viewport/view_window.h"

#include <QFile>
#include <QMouseEvent>
#include <QTest>

#include "editor/shell/action_table.h"
#include "eventually.h"

namespace trundle {

ViewWindow::ViewWindow(RenderService* render) : actions(actionTable()) {
    panel = std::make_unique<ViewportPanel>(document, selection, session, render, actions);
    QObject::connect(&document, &Document::refused, [this](const QString& why) { refusals.push_back(why); });
    QObject::connect(&document, &Document::selectionRequested, &selection, &Selection::set);
    panel->resize(900, 740);
    panel->show();
    (void)QTest::qWaitForWindowExposed(panel.get(), kTimeoutMs);
    panel->views().current().setFocus();
}

ViewWindow::~ViewWindow() = default;

bool ViewWindow::open(const QByteArray& text) {
    QFile file(folder.filePath(QStringLiteral("trial.sim")));
    if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size()) return false;
    file.close();
    return document.opening().open(file.fileName().toStdString()).ok();
}

bool ViewWindow::openSample(const char* name) {
    return document.opening().open(std::string(TRUNDLE_SOURCE_DIR "/configs/experiments/") + name).ok();
}

QByteArray ViewWindow::text() const {
    return QByteArray::fromStdString(*document.texts().text(document.texts().files().front()));
}

void ViewWindow::look(const Vec3& eye, const Vec3& target) {
    CameraView camera;
    camera.eye = eye;
    camera.target = target;
    view().camera().setView(camera);
}

QPoint ViewWindow::at(const Vec3& point) { return view().camera().pixelOf(point).value_or(QPointF(-1, -1)).toPoint(); }

void ViewWindow::move(const QPointF& to, Qt::KeyboardModifiers modifiers, Qt::MouseButtons buttons) {
    QMouseEvent event(QEvent::MouseMove, to, view().mapToGlobal(to), Qt::NoButton, buttons, modifiers);
    QCoreApplication::sendEvent(&view(), &event);
}

void ViewWindow::press(const QPointF& at, Qt::MouseButton button, Qt::KeyboardModifiers modifiers) {
    QMouseEvent event(QEvent::MouseButtonPress, at, view().mapToGlobal(at), button, button, modifiers);
    QCoreApplication::sendEvent(&view(), &event);
}

void ViewWindow::release(const QPointF& at, Qt::MouseButton button, Qt::KeyboardModifiers modifiers) {
    QMouseEvent event(QEvent::MouseButtonRelease, at, view().mapToGlobal(at), button, Qt::NoButton, modifiers);
    QCoreApplication::sendEvent(&view(), &event);
}

void ViewWindow::click(const QPointF& at, Qt::KeyboardModifiers modifiers) {
    press(at, Qt::LeftButton, modifiers);
    release(at, Qt::LeftButton, modifiers);
}

void ViewWindow::drag(const QPointF& from, const QPointF& to, Qt::MouseButton button, Qt::KeyboardModifiers modifiers) {
    press(from, button, modifiers);
    for (int i = 1; i <= 5; ++i) move(from + (to - from) * i / 5.0, modifiers, button);
    release(to, button, modifiers);
}

void ViewWindow::key(int key, Qt::KeyboardModifiers modifiers) { QTest::keyClick(&view(), Qt::Key(key), modifiers); }

void ViewWindow::type(const QString& text) { QTest::keyClicks(&view(), text); }

} // namespace trundle
