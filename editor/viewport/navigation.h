#pragma once
#include <set>

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include "editor/viewport/mouse_work.h"
#include "editor/viewport/navigation_style.h"
#include "scene/view.h"

namespace trundle {

class View;

/// Moves a view's camera: buttons orbit about what is under the cursor, pan and zoom as the navigation style says; the wheel zooms
/// to the cursor; with the right button down W A S D Q E fly (Shift: faster) and the mouse looks around.
class Navigation final : public QObject, public MouseWork {
    Q_OBJECT
public:
    explicit Navigation(View& view);

    bool press(const Pointer& pointer) override;
    void drag(const Pointer& pointer) override;
    void release(const Pointer& pointer) override;
    void cancel() override;
    bool key(QKeyEvent& event) override;

    void keyReleased(int key);
    void stopFlying();
    void wheel(const QPointF& at, double delta);

private:
    void fly();
    [[nodiscard]] QString hint() const;

    View& m_view;
    CameraDrag m_mode = CameraDrag::None;
    Qt::MouseButton m_button = Qt::NoButton;
    QPointF m_start, m_last;
    Vec3 m_about = Vec3::Zero(); ///< orbited about, held while panning, zoomed to
    bool m_moved = false, m_flown = false, m_fast = false;
    double m_speed = 1; ///< of flying, of the distance looked at per second
    std::set<int> m_keys;
    QTimer m_timer;
    QElapsedTimer m_sinceStep;
};

} // namespace trundle
