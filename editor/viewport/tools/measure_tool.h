#pragma once
#include <optional>
#include <vector>

#include <QObject>

#include "editor/viewport/context/view_tool.h"
#include "scene/queries/camera_view.h"

namespace trundle {

class ToolView;

/// The current measurement, shared by all views of a panel, so that its two points may be in different views.
class Measurement final : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;

    [[nodiscard]] const std::vector<Vec3>& points() const { return m_points; } ///< clicked points, at most two
    [[nodiscard]] const std::optional<Vec3>& next() const { return m_next; }   ///< under the cursor
    void add(const Vec3& point);                                               ///< a third point starts a new measurement
    void setNext(const std::optional<Vec3>& point);
    void clear();

Q_SIGNALS:
    void changed();

private:
    std::vector<Vec3> m_points;
    std::optional<Vec3> m_next;
};

/// Measure tool: shows the distance between two clicked points, in total and along each axis.
class MeasureTool final : public QObject, public ViewTool {
    Q_OBJECT
public:
    explicit MeasureTool(ToolView& view);

    bool press(const Pointer& pointer) override;
    bool hover(const Pointer& pointer) override;
    bool key(QKeyEvent& event) override;
    void paint(QPainter& painter) override;

private:
    [[nodiscard]] bool isOn() const;
    void showStatus();

    ToolView& m_view;
    Measurement& m_measured;
    bool m_hintShown = false;
};

} // namespace trundle
