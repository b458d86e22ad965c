#include "editor/viewport/pin_work.h"

#include <algorithm>

#include <QApplication>

#include "editor/document/selection.h"
#include "editor/viewport/view.h"

namespace trundle {

std::optional<PinnedPlate> PinWork::plateAt(const QPointF& at) const {
    const std::vector<PinnedPlate> plates = pinnedPlates(m_view);
    const auto hit = std::find_if(plates.rbegin(), plates.rend(), [&](const PinnedPlate& plate) { return plate.rect.contains(at); });
    return hit == plates.rend() ? std::nullopt : std::optional(*hit);
}

bool PinWork::press(const Pointer& pointer) {
    if (pointer.button != Qt::LeftButton) return false;
    m_held = plateAt(pointer.at);
    if (!m_held) return false;
    m_start = pointer.at;
    m_dragging = false;
    m_closing = m_held->close.contains(pointer.at);
    for (const Pin& pin : m_view.parts().pinned->pins())
        if (pin.path == m_held->path) m_before = pin.position;
    if (pointer.twice) m_view.parts().pinned->move(m_held->path, std::nullopt);
    return true;
}

void PinWork::drag(const Pointer& pointer) {
    if (!m_held) return;
    m_dragging |= (pointer.at - m_start).manhattanLength() >= QApplication::startDragDistance();
    if (!m_dragging || m_closing) return;
    m_view.setCursor(Qt::ClosedHandCursor);
    const QPointF middle = m_held->rect.center() + pointer.at - m_start;
    m_view.parts().pinned->move(m_held->path, QPointF(std::clamp(middle.x() / m_view.width(), 0.0, 1.0),
                                                      std::clamp(middle.y() / m_view.height(), 0.0, 1.0)));
}

void PinWork::release(const Pointer& pointer) {
    if (!m_held) return;
    const PinnedPlate held = *std::exchange(m_held, std::nullopt);
    m_view.unsetCursor();
    if (m_closing && held.close.contains(pointer.at)) m_view.parts().pinned->set({held.path}, false);
    else if (!m_dragging && !m_closing && !held.path.empty()) m_view.parts().selection.select(held.path);
}

void PinWork::cancel() {
    if (m_held && m_dragging) m_view.parts().pinned->move(m_held->path, m_before);
    m_held.reset();
    m_view.unsetCursor();
}

bool PinWork::hover(const Pointer& pointer) {
    const auto plate = plateAt(pointer.at);
    if (!plate) {
        leave();
        return false;
    }
    m_hovered = true;
    const bool closes = plate->close.contains(pointer.at);
    m_view.setCursor(closes ? Qt::ArrowCursor : Qt::OpenHandCursor);
    m_view.setHovered(plate->path, closes ? PinnedValues::tr("Unpin") : QString());
    return true;
}

void PinWork::leave() {
    if (std::exchange(m_hovered, false)) m_view.unsetCursor();
}

} // namespace trundle
