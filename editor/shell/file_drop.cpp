#include "editor/shell/file_drop.h"

#include <QDropEvent>
#include <QFileInfo>
#include <QMimeData>
#include <QUrl>
#include <QWidget>
#include <QWindow>

namespace trundle {

FileDrop::FileDrop(QWidget& window, std::function<void(const QString& path)> open)
    : QObject(&window), m_window(window), m_open(std::move(open)) {
    window.installEventFilter(this);
}

QString FileDrop::fileIn(const QMimeData& mime) {
    const QList<QUrl> urls = mime.urls();
    if (urls.size() != 1 || !urls.first().isLocalFile()) return {};
    const QFileInfo file(urls.first().toLocalFile());
    const bool text = file.suffix() == QStringLiteral("sim") || file.suffix() == QStringLiteral("txt");
    return text && file.isFile() ? file.filePath() : QString();
}

/// Drag events reach the QWindow before any widget.
bool FileDrop::eventFilter(QObject* watched, QEvent* event) {
    if (watched == &m_window) {
        if (event->type() == QEvent::Show && m_window.windowHandle()) m_window.windowHandle()->installEventFilter(this);
        return false;
    }
    const QEvent::Type type = event->type();
    if (type != QEvent::DragEnter && type != QEvent::DragMove && type != QEvent::Drop) return false;
    auto* drop = static_cast<QDropEvent*>(event);
    const QString file = fileIn(*drop->mimeData());
    if (file.isEmpty()) return false;
    drop->setDropAction(Qt::CopyAction); // the source must not delete the file
    drop->accept();
    if (type == QEvent::Drop)
        QMetaObject::invokeMethod(
            this, [this, file] { m_open(file); }, Qt::QueuedConnection);
    return true;
}

} // namespace trundle
