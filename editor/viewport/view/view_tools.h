#pragma once
#include <memory>
#include <vector>

#include <Qt>

class QKeyEvent;
class QMouseEvent;
class QPainter;
class QWheelEvent;

namespace trundle {

class AimTool;
class GizmoTool;
class JointTool;
class Navigation;
class ToolView;
class ViewTool;
struct Pointer;

/// The mouse tools of a view, in the order in which they are offered an event. The active one gets it first.
class ViewTools {
public:
    explicit ViewTools(ToolView& view); ///< must outlive this object
    ~ViewTools();

    [[nodiscard]] GizmoTool& gizmo() { return *m_gizmo; }
    [[nodiscard]] JointTool& joint() { return *m_joint; }
    [[nodiscard]] AimTool& aim() { return *m_aim; }
    [[nodiscard]] bool isActive() const { return m_active != nullptr; }
    [[nodiscard]] bool needsKey(const QKeyEvent& event) const; ///< instead of the window's shortcuts

    void press(const QMouseEvent& event);
    void move(const QMouseEvent& event);
    void release(const QMouseEvent& event);
    void wheel(const QWheelEvent& event);
    [[nodiscard]] bool key(QKeyEvent& event);
    void keyReleased(const QKeyEvent& event);
    void leave();
    /// The camera or the objects have moved below a resting mouse.
    void sceneMoved(const QPointF& mouse);
    void focusLost();
    void end(const Pointer& pointer); ///< of the active tool
    void paint(QPainter& painter) const;

private:
    void cancel();
    void hover(const Pointer& pointer);
    void updateLegend();

    ToolView& m_view;
    std::vector<std::unique_ptr<ViewTool>> m_tools;
    ViewTool* m_active = nullptr; // receives the mouse events
    Qt::MouseButton m_button = Qt::NoButton;
    Navigation* m_navigation = nullptr;
    GizmoTool* m_gizmo = nullptr;
    JointTool* m_joint = nullptr;
    AimTool* m_aim = nullptr;
};

} // namespace trundle
