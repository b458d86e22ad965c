#pragma once
#include <optional>
#include <vector>

#include <QObject>

#include "editor/viewport/mouse_work.h"
#include "scene/view.h"

namespace trundle {

class View;

/// What is being measured: one for all views of a panel, so that it can begin in one and end in another.
class Measurement final : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;

    [[nodiscard]] const std::vector<Vec3>& points() const { return m_points; } ///< clicked: none, one or both
    [[nodiscard]] const std::optional<Vec3>& next() const { return m_next; }   ///< under the cursor
    void add(const Vec3& point);                                               ///< a third one begins anew
    void setNext(const std::optional<Vec3>& point);
    void clear();

Q_SIGNALS:
    void changed();

private:
    std::vector<Vec3> m_points;
    std::optional<Vec3> m_next;
};

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
    Measurement& m_measured;
    bool m_said = false;
};

} // namespace trundle
