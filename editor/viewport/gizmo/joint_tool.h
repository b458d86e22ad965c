#pragma once
#include <optional>

#include <QObject>

#include "editor/viewport/context/view_tool.h"
#include "editor/viewport/gizmo/joint_handles.h"
#include "scene/queries/camera_view.h"

namespace trundle {

/// Moves the anchor of the selected joint, turns its axes and sets its stops, swing and travel with handles. A drag is one undo entry; Esc cancels it; a
/// double click on an axis reverses it.
class JointTool final : public QObject, public ViewTool {
    Q_OBJECT
public:
    explicit JointTool(ToolView& view);

    bool press(const Pointer& pointer) override;
    void drag(const Pointer& pointer) override;
    void release(const Pointer& pointer) override;
    void cancel() override;
    bool hover(const Pointer& pointer) override;
    void leave() override;
    void paint(QPainter& painter) override;

    /// Screen position of a handle, if it is visible.
    [[nodiscard]] std::optional<QPointF> spot(const JointHandle& handle);

private:
    [[nodiscard]] const EditedJoint* joint();
    [[nodiscard]] bool isOn() const;
    [[nodiscard]] bool snaps(const Pointer& pointer) const;
    void begin();
    [[nodiscard]] Vec3 draggedAnchor(const Pointer& pointer, double& fine) const; ///< in C
    [[nodiscard]] Vec3 draggedAxis(const Pointer& pointer) const;
    [[nodiscard]] double draggedStop(const Pointer& pointer, double& fine);
    [[nodiscard]] double draggedSwing(const Pointer& pointer, double& fine) const;  ///< rad
    [[nodiscard]] double draggedTravel(const Pointer& pointer, double& fine) const; ///< m
    [[nodiscard]] double angleAt(const ViewRay& ray, const Vec3& axis) const;
    void report(const Status& done);

    ToolView& m_view;
    std::optional<EditedJoint> m_joint;
    bool m_known = false;               ///< m_joint is that of the selection
    std::optional<EditedJoint> m_start; ///< during a drag: as before it
    JointHandle m_dragged, m_hot;
    double m_length = 0.1;               ///< m, of the arrows when the drag began
    double m_angle = 0, m_lastAngle = 0; ///< rad, of the dragged stop
    std::string m_mergeKey;
};

} // namespace trundle
