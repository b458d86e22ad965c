#pragma once
#include <vector>

#include <QObject>

#include "editor/viewport/mouse_work.h"
#include "scene/view.h"

namespace trundle {

class View;

/// With the measure tool: click two points, read their distance and how far apart they are along each axis.
class MeasureWork final : public QObject, public MouseWork {
    Q_OBJECT
public:
    explicit MeasureWork(View& view);

    bool press(const Pointer& pointer) override;
    bool hover(const Pointer& pointer) override;
    bool key(QKeyEvent& event) override;
    void paint(QPainter& painter) override;

private:
    [[nodiscard]] bool isOn() const;
    void say();

    View& m_view;
    std::vector<Vec3> m_points; ///< clicked: none, one or both
    std::optional<Vec3> m_next; ///< under the cursor
};

} // namespace trundle
