#pragma once
#include <optional>
#include <string>

#include "editor/viewport/mouse_work.h"
#include "editor/viewport/pinned_values.h"

namespace trundle {

/// Drags pinned plates, which take the mouse before all that is behind them. A click selects the object, one on the cross unpins it,
/// a double click puts the plate back into the column.
class PinWork final : public MouseWork {
public:
    explicit PinWork(View& view) : m_view(view) {}

    bool press(const Pointer& pointer) override;
    void drag(const Pointer& pointer) override;
    void release(const Pointer& pointer) override;
    void cancel() override;
    bool hover(const Pointer& pointer) override;
    void leave() override;

private:
    [[nodiscard]] std::optional<PinnedPlate> plateAt(const QPointF& at) const;

    View& m_view;
    std::optional<PinnedPlate> m_held; ///< as it was when it was pressed
    std::optional<QPointF> m_before;   ///< its Pin::position then
    QPointF m_start;
    bool m_dragging = false, m_closing = false, m_hovered = false;
};

} // namespace trundle
