#include "editor/viewport/tools/select_tool.h"

#include <QKeyEvent>
#include <QPainter>

#include "editor/document/selection.h"
#include "editor/viewport/context/tool_view.h"
#include "editor/viewport/context/view_settings.h"
#include "editor/viewport/context/viewport_scene.h"
#include "editor/viewport/overlays/regions.h"
#include "editor/widgets/theme.h"
#include "model/dotted_path.h"

namespace trundle {
namespace {

constexpr double kDragThreshold = 4; // pixels; drag threshold

QString kindOf(const ViewportScene& world, const std::string& path) {
    if (firstWord(path) != path) return {}; // paths of parts and configs already name them
    const auto object = world.find(path);
    if (const RobotSpec* robot = object ? world.objects()->robotOf(*object) : nullptr;
        robot && robot->config && object->kind == ObjectKind::Robot)
        return QString::fromStdString(robot->config->name);
    const StaticSpec* fixed = object && object->kind == ObjectKind::Static ? world.objects()->staticOf(*object) : nullptr;
    if (fixed) return QString::fromStdString(fixed->configName);
    return object ? QString() : QStringLiteral("Region");
}

/// pickChain() with the region that has an edge there: before the floor, behind everything else.
std::vector<std::string> chainAt(const ToolView& view, const QPointF& at) {
    const ViewportScene& world = view.context().world;
    std::vector<std::string> chain = pickChain(world, world.hitsAlong(view.camera().rayAt(at)));
    if (std::string region = regionAt(view, at); !region.empty())
        chain.insert(chain.empty() || chain.front().empty() ? chain.begin() : chain.end(), std::move(region));
    return chain;
}

} // namespace

bool SelectTool::press(const Pointer& pointer) {
    if (pointer.button != Qt::LeftButton) return false;
    m_start = m_now = pointer.at;
    m_pressed = true;
    m_boxing = false;
    return true;
}

void SelectTool::drag(const Pointer& pointer) {
    m_now = pointer.at;
    m_boxing |= (m_now - m_start).manhattanLength() > kDragThreshold;
    if (m_boxing) m_view.widget().update();
}

void SelectTool::release(const Pointer& pointer) {
    m_now = pointer.at;
    if (m_boxing) takeBox(pointer.modifiers);
    else click(pointer);
    m_boxing = m_pressed = false;
    m_view.widget().update();
}

void SelectTool::click(const Pointer& pointer) {
    Selection& selection = m_view.context().selection;
    std::vector<std::string> chain = chainAt(m_view, pointer.at);
    if (pointer.modifiers & (Qt::ControlModifier | Qt::ShiftModifier)) {
        if (!chain.empty() && !chain.front().empty()) selection.toggle(chain.front());
        return;
    }
    const std::string path = m_cycle.next(pointer.at, std::move(chain), selection.current());
    if (path.empty()) selection.clear();
    else selection.select(path);
}

void SelectTool::takeBox(Qt::KeyboardModifiers modifiers) {
    Selection& selection = m_view.context().selection;
    std::vector<std::string> paths = boxPick(m_view, QRectF(m_start, m_now).normalized());
    if (modifiers & (Qt::ControlModifier | Qt::ShiftModifier)) {
        std::vector<std::string> all = selection.paths();
        all.insert(all.end(), paths.begin(), paths.end());
        paths = std::move(all);
    }
    selection.set(std::move(paths));
}

bool SelectTool::hover(const Pointer& pointer) {
    const ViewportScene& world = m_view.context().world;
    const std::vector<std::string> chain = chainAt(m_view, pointer.at);
    if (chain.empty() || chain.front().empty()) return false;
    const QString name = QString::fromStdString(chain.front()), kind = kindOf(world, chain.front());
    m_view.hints().setHovered(chain.front(), kind.isEmpty() ? name : name + QStringLiteral("  ·  ") + kind);
    return true;
}

bool SelectTool::key(QKeyEvent& event) {
    if (event.key() != Qt::Key_Escape || m_pressed || m_view.context().selection.empty()) return false;
    m_view.context().selection.clear();
    return true;
}

void SelectTool::paint(QPainter& painter) {
    if (!m_boxing) return;
    QColor fill = ink(Ink::Accent);
    painter.setPen(QPen(fill, 1));
    fill.setAlpha(40);
    painter.setBrush(fill);
    painter.drawRect(QRectF(m_start, m_now).normalized());
}

} // namespace trundle
