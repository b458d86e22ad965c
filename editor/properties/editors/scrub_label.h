#pragma once
#include <QLabel>

namespace trundle {

/// A label that changes a number when dragged left or right; Shift: finer, Ctrl: coarser.
class ScrubLabel final : public QLabel {
    Q_OBJECT
public:
    explicit ScrubLabel(QWidget* parent = nullptr);
    void setScrubbing(bool on);

Q_SIGNALS:
    void dragged(double steps); ///< relative to the start of the drag
    void ended();
    void clicked();
    void cancelled(); ///< by Esc: restore the value

protected:
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    bool m_on = false, m_down = false, m_moved = false;
    QPointF m_last;
    double m_steps = 0;
};

} // namespace trundle
