#pragma once
#include <functional>

#include <QObject>
#include <QString>

class QMimeData;
class QWidget;

namespace trundle {

/// Opens a file that is dropped anywhere on a window, including panels that would insert it as text.
class FileDrop final : public QObject {
public:
    /// Owned by the window. `open` is called after the drop has finished, since it may ask questions.
    FileDrop(QWidget& window, std::function<void(const QString& path)> open);

    /// The path, if the data is a single supported file; else empty.
    [[nodiscard]] static QString fileIn(const QMimeData& mime);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QWidget& m_window;
    std::function<void(const QString&)> m_open;
};

} // namespace trundle
