#pragma once
#include <QSize>
#include <QWidget>

class QComboBox;
class QSpinBox;

namespace trundle {

/// How large a picture is to be: a few usual sizes, or any up to what can be drawn.
class SizeChoice final : public QWidget {
    Q_OBJECT
public:
    /// `shown`: of the view on the screen; not offered where it is empty.
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
