#pragma once
#include <set>

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include "editor/viewport/context/view_tool.h"
#include "editor/viewport/tools/navigation_style.h"
#include "scene/queries/camera_view.h"

namespace trundle {

class ToolView;

/// Camera navigation of a view: buttons orbit about the point under the cursor, pan and zoom as the navigation style defines; the
/// wheel zooms towards the cursor. With the right button held, W A S D Q E fly (Shift: faster) and the mouse rotates the view.
class Navigation final : public QObject, public ViewTool {
    Q_OBJECT
public:
    explicit Navigation(ToolView& view);

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

    ToolView& m_view;
    CameraDrag m_mode = CameraDrag::None;
    Qt::MouseButton m_button = Qt::NoButton;
    QPointF m_start, m_last;
    Vec3 m_about = Vec3::Zero(); ///< centre of orbiting, panning and zooming, in world coordinates
    bool m_moved = false, m_flown = false, m_fast = false;
    double m_speed = 1; ///< flying speed, in view distances per second
    std::set<int> m_keys;
    QTimer m_timer;
    QElapsedTimer m_sinceStep;
};

} // namespace trundle
