#pragma once
#include <functional>

#include <QObject>
#include <QString>

class QMimeData;
class QWidget;

namespace trundle {

/// Opens a text that is dropped anywhere on a window, also on a panel that takes what is dropped for words to insert.
class FileDrop final : public QObject {
public:
    /// Lives as long as the window. `open` is called once the drop is over, as it may ask questions.
    FileDrop(QWidget& window, std::function<void(const QString& path)> open);

    /// The one file that is carried; empty where it is none of ours.
    [[nodiscard]] static QString fileIn(const QMimeData& mime);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QWidget& m_window;
    std::function<void(const QString&)> m_open;
};

} // namespace trundle
