#pragma once
#include <memory>

#include <QObject>
#include <QTimer>

#include "editor/viewport/context/view_tool.h"
#include "editor/viewport/gizmo/gizmo_drag.h"
#include "editor/viewport/gizmo/move_snap.h"
#include "editor/viewport/gizmo/transform_selection.h"

namespace trundle {

class ToolView;

/// Moves, rotates and scales the selection with the gizmo's handles or the arrow keys. A drag is one undo entry; Esc cancels it.
class GizmoTool final : public QObject, public ViewTool {
    Q_OBJECT
public:
    explicit GizmoTool(ToolView& view);

    bool press(const Pointer& pointer) override;
    void drag(const Pointer& pointer) override;
    void release(const Pointer& pointer) override;
    void cancel() override;
    bool hover(const Pointer& pointer) override;
    void leave() override;
    bool key(QKeyEvent& event) override;
    void paint(QPainter& painter) override;

    /// Screen position of a handle, if it is visible.
    [[nodiscard]] std::optional<QPointF> spot(const GizmoHandle& handle);

private:
    [[nodiscard]] TransformSelection::Operation purpose() const;
    [[nodiscard]] TransformSelection* held();
    /// `layout`: of the handles for the extent of a whole Grid or Scatter.
    [[nodiscard]] std::optional<GizmoPose> place(bool layout);
    [[nodiscard]] std::optional<Gizmo> gizmo(bool asShown, bool layout);
    [[nodiscard]] GizmoHandle hit(const QPointF& at);
    void addSight(GizmoPose& place) const; ///< what depends on the camera
    void apply();
    void showStatus();
    bool nudge(const QKeyEvent& event);
    [[nodiscard]] bool snaps(const Pointer& pointer) const;
    [[nodiscard]] DragFineness fineness() const;

    ToolView& m_view;
    std::unique_ptr<TransformSelection> m_held; // null: to be rebuilt from the selection
    std::unique_ptr<TransformSelection> m_dragged;
    std::unique_ptr<GizmoDrag> m_drag;
    std::unique_ptr<MoveSnap> m_snap; // null: the handle only turns or resizes
    GizmoPose m_startPlace;
    GizmoHandle m_hot;
    Pointer m_pointer;
    std::string m_mergeKey;
    QString m_name;
    QTimer m_pace; // while it runs, further edits wait
    bool m_pending = false;
};

} // namespace trundle
