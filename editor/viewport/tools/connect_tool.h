#pragma once
#include <optional>
#include <string>

#include <QObject>

#include "editor/viewport/context/view_tool.h"
#include "scene/queries/object_index.h"

namespace trundle {

class ToolView;

/// Joins bodies: a drag from one body to another inserts a joint of the chosen kind, with the first as its parent. From the floor, the parent
/// is the world. One edit; then the joint is selected, for its handles.
class ConnectTool final : public QObject, public ViewTool {
    Q_OBJECT
public:
    explicit ConnectTool(ToolView& view);

    bool press(const Pointer& pointer) override;
    void drag(const Pointer& pointer) override;
    void release(const Pointer& pointer) override;
    void cancel() override;
    bool hover(const Pointer& pointer) override;
    [[nodiscard]] bool needsKey(const QKeyEvent& event) const override;
    bool key(QKeyEvent& event) override;
    void paint(QPainter& painter) override;

private:
    /// A place on a body, or of the scenery.
    struct Picked {
        std::optional<ObjectRef> body;                     ///< nothing: scenery, which is the world
        Vec3 point = Vec3::Zero(), normal = Vec3::UnitZ(); ///< W
    };
    [[nodiscard]] bool isOn() const;
    [[nodiscard]] std::optional<Picked> pickAt(const QPointF& at) const;
    [[nodiscard]] QString nameOf(const Picked& picked) const;
    [[nodiscard]] QString refusal(const Picked& from, const Picked& to) const; ///< empty: they can be joined
    void showHint();
    void connectBodies(const Picked& from, const Picked& to);

    ToolView& m_view;
    std::optional<Picked> m_from, m_to;
    QPointF m_now;
    bool m_hintShown = false;
};

} // namespace trundle
