#pragma once
#include <optional>

#include <QObject>

#include "editor/viewport/context/view_tool.h"
#include "editor/viewport/tools/floor_snap.h"

namespace trundle {

class FloorDrawing;
class ScenePainter;
class ToolView;

/// Draws walls or a line on the floor, corner by corner. The piece under way is shown with its length and angle; typed numbers set
/// them. Enter or a double click writes the path, Backspace removes the last corner, Esc leaves.
class DrawTool final : public QObject, public ViewTool {
    Q_OBJECT
public:
    explicit DrawTool(ToolView& view);

    bool press(const Pointer& pointer) override;
    bool hover(const Pointer& pointer) override;
    void leave() override;
    [[nodiscard]] bool needsKey(const QKeyEvent& event) const override;
    bool key(QKeyEvent& event) override;
    void paint(QPainter& painter) override;

private:
    [[nodiscard]] std::optional<FloorSnap> cornerAt(const Pointer& pointer) const;
    [[nodiscard]] bool isUnderWay() const;
    void enter();
    void escape();
    void showStatus();
    void update();
    void paintPiece(const ScenePainter& scene, const FloorPoint& from, const FloorPoint& to) const;
    void paintSnap(QPainter& painter, const ScenePainter& scene) const;
    void paintRightAngle(const ScenePainter& scene) const;
    [[nodiscard]] QString readOut() const;

    ToolView& m_view;
    FloorDrawing& m_drawing;
    std::optional<Pointer> m_pointer; ///< last place of the mouse in this view
    std::optional<FloorSnap> m_next;  ///< the corner there
    bool m_hintShown = false;
};

} // namespace trundle
