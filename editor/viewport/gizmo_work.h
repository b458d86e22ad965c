#pragma once
#include <memory>

#include <QObject>
#include <QTimer>

#include "editor/viewport/gizmo_drag.h"
#include "editor/viewport/held_objects.h"
#include "editor/viewport/mouse_work.h"

namespace trundle {

class View;

/// Moves, turns and sizes what is selected by the handles of a gizmo, or by the arrow keys. A drag is one entry of the history;
/// Esc takes it back.
class GizmoWork final : public QObject, public MouseWork {
    Q_OBJECT
public:
    explicit GizmoWork(View& view);

    bool press(const Pointer& pointer) override;
    void drag(const Pointer& pointer) override;
    void release(const Pointer& pointer) override;
    void cancel() override;
    bool hover(const Pointer& pointer) override;
    void leave() override;
    bool key(QKeyEvent& event) override;
    void paint(QPainter& painter) override;

    /// Where a handle is now, if it is there.
    [[nodiscard]] std::optional<QPointF> spot(const Handle& handle);

private:
    [[nodiscard]] HeldObjects::Purpose purpose() const;
    [[nodiscard]] HeldObjects* held();
    [[nodiscard]] std::optional<GizmoPlace> place();
    [[nodiscard]] std::optional<Gizmo> gizmo(bool asShown);
    void apply();
    void say();
    bool nudge(const QKeyEvent& event);
    [[nodiscard]] Fineness fineness(bool snapped) const;

    View& m_view;
    std::unique_ptr<HeldObjects> m_held; // null: to be taken anew
    std::unique_ptr<HeldObjects> m_dragged;
    std::unique_ptr<GizmoDrag> m_drag;
    GizmoPlace m_startPlace;
    Handle m_hot;
    Pointer m_pointer;
    std::string m_mergeKey;
    QString m_name;
    QTimer m_pace; // while it runs, an edit is young and the next one waits
    bool m_pending = false;
};

} // namespace trundle
