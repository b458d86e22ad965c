#pragma once
#include "editor/viewport/context/view_tool.h"
#include "editor/viewport/tools/picking.h"

namespace trundle {

/// Selects by click, repeated clicks go to parts and then to objects behind; Ctrl+click adds or removes; a drag selects a box;
/// Esc clears.
class SelectTool final : public ViewTool {
public:
    explicit SelectTool(ToolView& view) : m_view(view) {}

    bool press(const Pointer& pointer) override;
    void drag(const Pointer& pointer) override;
    void release(const Pointer& pointer) override;
    void cancel() override { m_boxing = m_pressed = false; }
    bool hover(const Pointer& pointer) override;
    bool key(QKeyEvent& event) override;
    void paint(QPainter& painter) override;

private:
    void click(const Pointer& pointer);
    void takeBox(Qt::KeyboardModifiers modifiers);

    ToolView& m_view;
    PickCycle m_cycle;
    QPointF m_start, m_now;
    bool m_pressed = false, m_boxing = false;
};

} // namespace trundle
