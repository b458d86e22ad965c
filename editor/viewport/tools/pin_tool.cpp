#include "editor/viewport/tools/pin_tool.h"

#include <algorithm>

#include <QApplication>

#include "editor/document/selection.h"
#include "editor/viewport/context/tool_view.h"

namespace trundle {

std::optional<PinnedLabel> PinTool::labelAt(const QPointF& at) const {
    const std::vector<PinnedLabel> labels = pinnedLabels(m_view);
    const auto hit =
        std::find_if(labels.rbegin(), labels.rend(), [&](const PinnedLabel& label) { return label.rect.contains(at); });
    return hit == labels.rend() ? std::nullopt : std::optional(*hit);
}

bool PinTool::press(const Pointer& pointer) {
    if (pointer.button != Qt::LeftButton) return false;
    m_held = labelAt(pointer.at);
    if (!m_held) return false;
    m_start = pointer.at;
    m_dragging = false;
    m_closing = m_held->close.contains(pointer.at);
    for (const Pin& pin : m_view.context().pinned->pins())
        if (pin.path == m_held->path) m_before = pin.position;
    if (pointer.twice) m_view.context().pinned->move(m_held->path, std::nullopt);
    return true;
}

void PinTool::drag(const Pointer& pointer) {
    if (!m_held) return;
    m_dragging |= (pointer.at - m_start).manhattanLength() >= QApplication::startDragDistance();
    if (!m_dragging || m_closing) return;
    m_view.widget().setCursor(Qt::ClosedHandCursor);
    const QPointF middle = m_held->rect.center() + pointer.at - m_start;
    m_view.context().pinned->move(m_held->path, QPointF(std::clamp(middle.x() / m_view.widget().width(), 0.0, 1.0),
                                                        std::clamp(middle.y() / m_view.widget().height(), 0.0, 1.0)));
}

void PinTool::release(const Pointer& pointer) {
    if (!m_held) return;
    const PinnedLabel held = *std::exchange(m_held, std::nullopt);
    m_view.widget().unsetCursor();
    if (m_closing && held.close.contains(pointer.at)) m_view.context().pinned->set({held.path}, false);
    else if (!m_dragging && !m_closing && !held.path.empty()) m_view.context().selection.select(held.path);
}

void PinTool::cancel() {
    if (m_held && m_dragging) m_view.context().pinned->move(m_held->path, m_before);
    m_held.reset();
    m_view.widget().unsetCursor();
}

bool PinTool::hover(const Pointer& pointer) {
    const auto label = labelAt(pointer.at);
    if (!label) {
        leave();
        return false;
    }
    m_hovered = true;
    const bool closes = label->close.contains(pointer.at);
    m_view.widget().setCursor(closes ? Qt::ArrowCursor : Qt::OpenHandCursor);
    m_view.hints().setHovered(label->path, closes ? PinnedValues::tr("Unpin") : QString());
    return true;
}

void PinTool::leave() {
    if (std::exchange(m_hovered, false)) m_view.widget().unsetCursor();
}

} // namespace trundle
