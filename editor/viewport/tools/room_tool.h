#pragma once
#include <optional>

#include <QObject>

#include "editor/viewport/context/view_tool.h"
#include "editor/viewport/tools/scenery_target.h"
#include "editor/viewport/tools/typed_numbers.h"
#include "project/wizard/floor_path.h"

namespace trundle {

class ToolView;

/// Drags the inside of a room on the floor, from corner to corner, or clicks both corners; typed numbers are its length along x and its
/// width along y. Its walls are one entry of the history. Esc takes the corner back, then leaves.
class RoomTool final : public QObject, public ViewTool {
    Q_OBJECT
public:
    explicit RoomTool(ToolView& view);

    bool press(const Pointer& pointer) override;
    void drag(const Pointer& pointer) override;
    void release(const Pointer& pointer) override;
    void cancel() override;
    bool hover(const Pointer& pointer) override;
    [[nodiscard]] bool needsKey(const QKeyEvent& event) const override;
    bool key(QKeyEvent& event) override;
    void paint(QPainter& painter) override;

private:
    [[nodiscard]] bool isOn() const;
    [[nodiscard]] std::optional<FloorPoint> pointAt(const Pointer& pointer) const;
    /// The corner opposite to the first one, with what is typed.
    [[nodiscard]] FloorPoint opposite() const;
    void follow(const Pointer& pointer);
    void finish();
    void clear();
    void showHint();
    void paintWalls(QPainter& painter) const;

    ToolView& m_view;
    SceneryTarget m_target;
    std::optional<FloorPoint> m_from;
    FloorPoint m_to{};
    TypedNumbers m_typed{false};
    bool m_hintShown = false;
};

} // namespace trundle
