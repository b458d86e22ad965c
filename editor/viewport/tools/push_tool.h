#pragma once
#include <optional>

#include <QObject>

#include "editor/viewport/context/view_tool.h"
#include "scene/queries/object_index.h"

namespace trundle {

class ToolView;

/// During a run, a drag with Ctrl pulls a body towards the cursor, in the plane that faces the camera, with a force proportional
/// to the distance. A click with Ctrl has its usual meaning.
class PushTool final : public QObject, public ViewTool {
    Q_OBJECT
public:
    explicit PushTool(ToolView& view);

    bool press(const Pointer& pointer) override;
    void drag(const Pointer& pointer) override;
    void release(const Pointer& pointer) override;
    void cancel() override;
    [[nodiscard]] bool canHandleKeys() const override { return false; } // the user may pause the run while pushing
    void paint(QPainter& painter) override;

private:
    void push();
    [[nodiscard]] Vec3 gripNow() const;

    ToolView& m_view;
    std::optional<ObjectRef> m_body;
    Vec3 m_grip = Vec3::Zero(); ///< point of application, in the body's frame
    Vec3 m_force = Vec3::Zero();
    QPointF m_start, m_now;
    double m_mass = 1; ///< kg, of the whole robot
    bool m_pushing = false;
};

} // namespace trundle
