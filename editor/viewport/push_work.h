#pragma once
#include <optional>

#include <QObject>

#include "editor/viewport/mouse_work.h"
#include "scene/object_index.h"

namespace trundle {

class View;

/// While a world runs, Ctrl and a drag push a body: it is pulled towards the cursor, the harder the farther, in the plane that
/// faces the camera. Ctrl and a click stay what they are elsewhere.
class PushWork final : public QObject, public MouseWork {
    Q_OBJECT
public:
    explicit PushWork(View& view);

    bool press(const Pointer& pointer) override;
    void drag(const Pointer& pointer) override;
    void release(const Pointer& pointer) override;
    void cancel() override;
    [[nodiscard]] bool takesKeys() const override { return false; } // who pushes may pause the run
    void paint(QPainter& painter) override;

private:
    void push();
    [[nodiscard]] Vec3 gripNow() const;

    View& m_view;
    std::optional<ObjectRef> m_body;
    Vec3 m_grip = Vec3::Zero(); ///< in the body's frame
    Vec3 m_force = Vec3::Zero();
    QPointF m_start, m_now;
    double m_mass = 1; ///< kg, of the whole robot
    bool m_pushing = false;
};

} // namespace trundle
