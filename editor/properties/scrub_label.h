#pragma once
#include <QLabel>

namespace trundle {

/// A label on which a number is changed by dragging left and right; Shift is finer, Ctrl coarser.
class ScrubLabel final : public QLabel {
    Q_OBJECT
public:
    explicit ScrubLabel(QWidget* parent = nullptr);
    void setScrubbing(bool on);

Q_SIGNALS:
    void dragged(double steps); ///< from where the drag began
    void ended();
    void clicked();
    void abandoned(); ///< Esc: as it was

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
