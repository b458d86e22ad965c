#pragma once
#include <QSize>
#include <QWidget>

class QComboBox;
class QSpinBox;

namespace trundle {

/// Selects the size of an image: a few common sizes, or any up to the renderer's limit.
class SizeChoice final : public QWidget {
    Q_OBJECT
public:
    /// `shown`: size of the viewport; not offered if empty.
    explicit SizeChoice(QSize shown, QWidget* parent = nullptr);
    [[nodiscard]] QSize size() const;
    void setSize(QSize size);

Q_SIGNALS:
    void changed();

private:
    void takeNamed();
    void showName();

    QComboBox* m_named;
    QSpinBox *m_width, *m_height;
};

} // namespace trundle
