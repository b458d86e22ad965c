#pragma once
#include <optional>
#include <string>

#include "editor/viewport/context/view_tool.h"
#include "editor/viewport/overlays/pinned_values.h"

namespace trundle {

/// Tool for the labels of pinned values; it has priority over the tools behind them. A drag moves a label, a click selects the
/// object, a click on the cross unpins it, a double click returns the label to the column.
class PinTool final : public ViewTool {
public:
    explicit PinTool(ToolView& view) : m_view(view) {}

    bool press(const Pointer& pointer) override;
    void drag(const Pointer& pointer) override;
    void release(const Pointer& pointer) override;
    void cancel() override;
    bool hover(const Pointer& pointer) override;
    void leave() override;

private:
    [[nodiscard]] std::optional<PinnedLabel> labelAt(const QPointF& at) const;

    ToolView& m_view;
    std::optional<PinnedLabel> m_held; ///< state of the label at the press
    std::optional<QPointF> m_before;   ///< Pin::position at the press
    QPointF m_start;
    bool m_dragging = false, m_closing = false, m_hovered = false;
};

} // namespace trundle
