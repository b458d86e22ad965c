#include "editor/viewport/view/view_tools.h"

#include <algorithm>
#include <utility>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QWidget>

#include "editor/viewport/context/tool_view.h"
#include "editor/viewport/gizmo/aim_tool.h"
#include "editor/viewport/gizmo/gizmo_tool.h"
#include "editor/viewport/gizmo/joint_tool.h"
#include "editor/viewport/radio/radio_overlays.h"
#include "editor/viewport/tools/connect_tool.h"
#include "editor/viewport/tools/draw_tool.h"
#include "editor/viewport/tools/measure_tool.h"
#include "editor/viewport/tools/navigation.h"
#include "editor/viewport/tools/pin_tool.h"
#include "editor/viewport/tools/push_tool.h"
#include "editor/viewport/tools/room_tool.h"
#include "editor/viewport/tools/select_tool.h"

namespace trundle {
namespace {

Pointer pointerOf(const QMouseEvent& event) {
    return {event.position(), event.button(), event.modifiers(), event.type() == QEvent::MouseButtonDblClick};
}

} // namespace

ViewTools::ViewTools(ToolView& view) : m_view(view) {
    m_tools.push_back(std::make_unique<PinTool>(view));
    auto navigation = std::make_unique<Navigation>(view);
    m_navigation = navigation.get();
    m_tools.push_back(std::move(navigation));
    m_tools.push_back(std::make_unique<MeasureTool>(view));
    m_tools.push_back(std::make_unique<DrawTool>(view));
    m_tools.push_back(std::make_unique<RoomTool>(view));
    auto joint = std::make_unique<JointTool>(view);
    m_joint = joint.get();
    m_tools.push_back(std::move(joint));
    auto aim = std::make_unique<AimTool>(view);
    m_aim = aim.get();
    m_tools.push_back(std::move(aim));
    m_tools.push_back(std::make_unique<ConnectTool>(view));
    auto gizmo = std::make_unique<GizmoTool>(view);
    m_gizmo = gizmo.get();
    m_tools.push_back(std::move(gizmo));
    m_tools.push_back(std::make_unique<PushTool>(view));
    m_tools.push_back(std::make_unique<SelectTool>(view));
}

ViewTools::~ViewTools() = default;

bool ViewTools::needsKey(const QKeyEvent& event) const {
    if (m_active) return m_active->canHandleKeys();
    return std::ranges::any_of(m_tools, [&](const auto& tool) { return tool->needsKey(event); });
}

void ViewTools::press(const QMouseEvent& event) {
    if (m_active) return; // further buttons are ignored during a drag
    const Pointer pointer = pointerOf(event);
    for (const auto& tool : m_tools) {
        if (!tool->press(pointer)) continue;
        m_active = tool.get();
        m_button = event.button();
        m_view.hints().setHovered({}, {});
        return;
    }
}

void ViewTools::move(const QMouseEvent& event) {
    const Pointer pointer = pointerOf(event);
    if (m_active && !event.buttons().testFlag(m_button)) m_view.endTool(pointer); // a dialog received the release
    if (m_active) return m_active->drag(pointer);
    hover(pointer);
}

void ViewTools::sceneMoved(const QPointF& mouse) {
    if (!m_active) hover({mouse, Qt::NoButton, {}, false});
}

void ViewTools::hover(const Pointer& pointer) {
    bool taken = false;
    for (const auto& tool : m_tools) {
        if (taken) tool->leave();
        else taken = tool->hover(pointer);
    }
    if (!taken) m_view.hints().setHovered({}, {});
    updateLegend();
}

void ViewTools::release(const QMouseEvent& event) {
    if (!m_active || event.button() != m_button) return;
    m_view.endTool(pointerOf(event));
}

void ViewTools::wheel(const QWheelEvent& event) {
    m_navigation->wheel(event.position(), event.angleDelta().y() != 0 ? event.angleDelta().y() : event.pixelDelta().y() * 4.0);
}

bool ViewTools::key(QKeyEvent& event) {
    if (m_active && m_active->key(event)) return true;
    if (event.key() == Qt::Key_Escape && m_active) return cancel(), true;
    if (event.key() == Qt::Key_Escape && m_view.camera().isThrough()) return m_view.camera().lookThrough({}), true;
    for (const auto& tool : m_tools)
        if (tool.get() != m_active && tool->key(event)) return true;
    return false;
}

void ViewTools::keyReleased(const QKeyEvent& event) {
    if (!event.isAutoRepeat()) m_navigation->keyReleased(event.key());
}

void ViewTools::leave() {
    if (m_active) return;
    for (const auto& tool : m_tools) tool->leave();
    m_view.hints().setHovered({}, {});
    updateLegend();
}

/// The legend of the radio overlays shows more under the pointer.
void ViewTools::updateLegend() {
    const RadioOverlays* radios = m_view.context().radios;
    if (radios && !radios->nodes().empty()) m_view.widget().update();
}

void ViewTools::focusLost() { m_navigation->stopFlying(); }

void ViewTools::end(const Pointer& pointer) {
    if (ViewTool* done = std::exchange(m_active, nullptr)) done->release(pointer);
}

void ViewTools::cancel() {
    std::exchange(m_active, nullptr)->cancel();
    m_view.widget().update();
}

void ViewTools::paint(QPainter& painter) const {
    for (const auto& tool : m_tools) tool->paint(painter);
}

} // namespace trundle
