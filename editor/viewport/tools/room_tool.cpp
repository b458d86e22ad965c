#include "editor/viewport/tools/room_tool.h"

#include <cmath>
#include <utility>

#include <QKeyEvent>
#include <QPainter>
#include <QWidget>

#include "editor/document/document.h"
#include "editor/viewport/context/label.h"
#include "editor/viewport/context/scene_painter.h"
#include "editor/viewport/context/tool_view.h"
#include "editor/viewport/context/view_settings.h"
#include "editor/viewport/context/viewport_scene.h"
#include "editor/viewport/tools/floor_snap.h"
#include "editor/widgets/strings.h"
#include "lang/number_text.h"
#include "project/wizard/arena_text.h"

namespace trundle {
namespace {

constexpr double kFarthestCorner = 1000; // m, from the camera
constexpr double kLeastSide = 0.2;       // m; a smaller drag is a click
const QColor kRoomInk(255, 208, 60);

QString metres(double value) { return QString::fromStdString(steppedNumber(value, 1e-3)) + RoomTool::tr(" m"); }

} // namespace

RoomTool::RoomTool(ToolView& view) : m_view(view) {
    const ViewContext& context = view.context();
    connect(&context.settings, &ViewSettings::changed, this, [this] {
        if (!isOn()) clear();
        showHint();
    });
    connect(&context.document, &Document::opened, this, &RoomTool::clear);
    connect(&context.document.editedModel(), &EditedModel::changed, this, &RoomTool::clear);
}

bool RoomTool::isOn() const { return m_view.context().settings.tool() == Tool::DrawRoom; }

/// On the grid unless snapping is off. Nothing above the horizon.
std::optional<FloorPoint> RoomTool::pointAt(const Pointer& pointer) const {
    const ViewRay ray = m_view.camera().rayAt(pointer.at);
    if (std::abs(ray.direction.z()) < 1e-9) return std::nullopt;
    const double distance = (m_target.X_WP.position.z() - ray.origin.z()) / ray.direction.z();
    if (distance < 0 || distance > kFarthestCorner) return std::nullopt;
    const Vec3 under = ray.origin + distance * ray.direction;
    const ViewSettings& settings = m_view.context().settings;
    const bool snaps = settings.snaps() != bool(pointer.modifiers & (Qt::ControlModifier | Qt::ShiftModifier));
    FloorSnapOptions options;
    options.step = snaps ? settings.moveStep() : 0;
    return snapOnFloor({under.x(), under.y()}, {}, options).point;
}

FloorPoint RoomTool::opposite() const {
    FloorPoint to = m_to;
    for (const bool second : {false, true})
        if (const auto side = m_typed.number(second, "m"); side && *side > 0) {
            const std::size_t k = second ? 1 : 0;
            to[k] = (*m_from)[k] + (m_to[k] < (*m_from)[k] ? -*side : *side);
        }
    return to;
}

bool RoomTool::press(const Pointer& pointer) {
    if (!isOn() || pointer.button != Qt::LeftButton) return false;
    if (m_from) return follow(pointer), true;
    Document& document = m_view.context().document;
    if (!canHaveScenery(document)) return true;
    m_target = sceneryTarget(document, m_view.context().world);
    m_from = pointAt(pointer);
    follow(pointer);
    return true;
}

void RoomTool::follow(const Pointer& pointer) {
    if (m_from) m_to = pointAt(pointer).value_or(m_to);
    showHint();
    m_view.widget().update();
}

void RoomTool::drag(const Pointer& pointer) { follow(pointer); }

/// A drag ends the room; a click leaves its first corner.
void RoomTool::release(const Pointer& pointer) {
    if (!m_from) return;
    follow(pointer);
    const FloorPoint to = opposite();
    if (std::abs(to[0] - (*m_from)[0]) >= kLeastSide && std::abs(to[1] - (*m_from)[1]) >= kLeastSide) finish();
}

void RoomTool::cancel() { clear(); }

bool RoomTool::hover(const Pointer& pointer) {
    if (!isOn()) return false;
    m_view.hints().setHovered({}, {});
    follow(pointer);
    return true;
}

bool RoomTool::needsKey(const QKeyEvent& event) const {
    if (!isOn() || event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)) return false;
    if (event.key() == Qt::Key_Escape) return true;
    if (!m_from) return false;
    switch (event.key()) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
    case Qt::Key_Backspace:
    case Qt::Key_Tab: return true;
    default: break;
    }
    if (event.text().size() != 1) return false;
    const QChar c = event.text()[0];
    return c.isDigit() || c == u'.' || c == u',' || !m_typed.empty();
}

bool RoomTool::key(QKeyEvent& event) {
    if (!needsKey(event)) return false;
    if (event.key() == Qt::Key_Escape) {
        if (m_from) clear();
        else m_view.context().settings.setTool(Tool::Select);
    } else if (event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter) {
        finish();
    } else if (!m_typed.type(event.key(), event.text()) && event.key() == Qt::Key_Backspace) {
        clear();
    }
    m_view.widget().update();
    return true;
}

void RoomTool::finish() {
    const FloorPoint from = *m_from, to = opposite();
    Document& document = m_view.context().document;
    RoomOptions options;
    options.length = std::abs(to[0] - from[0]), options.width = std::abs(to[1] - from[1]);
    const Result<RoomPlan> plan = roomPlan(options);
    if (!plan) return void(Q_EMIT document.refused(toQString(plan.error().message)));
    clear();
    const Vec3 middle = m_target.X_WP.inverse() * Vec3((from[0] + to[0]) / 2, (from[1] + to[1]) / 2, m_target.X_WP.position.z());
    const bool needsFloor = !hasFloor(m_view.context().world);
    const std::array<double, 2> place{middle.x(), middle.y()};
    insertScenery(document, m_target, tr("Draw Room"), roomBlocksText("Room", plan.value(), needsFloor, place),
                  roomBoxesText(plan.value(), needsFloor, place));
}

void RoomTool::clear() {
    m_from.reset();
    m_typed.clear();
    showHint();
    m_view.widget().update();
}

void RoomTool::showHint() {
    if (!isOn()) {
        if (std::exchange(m_hintShown, false)) m_view.hints().setHint({}); // clears only this tool's own hint
        return;
    }
    m_hintShown = true;
    m_view.hints().setHint(m_from
                               ? tr("Release or click at the opposite corner · Or type the length, Tab, the width · Enter ends · "
                                    "Esc cancels")
                               : tr("Drag the inside of a room on the floor · Esc leaves · Ctrl toggles snapping"));
}

void RoomTool::paint(QPainter& painter) {
    if (isOn() && m_from) paintWalls(painter);
}

/// The edges inside, those outside at the top, and the sides along x and y.
void RoomTool::paintWalls(QPainter& painter) const {
    const RoomOptions options;
    const FloorPoint to = opposite();
    const double low[] = {std::min((*m_from)[0], to[0]), std::min((*m_from)[1], to[1])};
    const double high[] = {std::max((*m_from)[0], to[0]), std::max((*m_from)[1], to[1])};
    const double floor = m_target.X_WP.position.z();
    const ScenePainter scene(painter, m_view);
    const auto corner = [&](int i, double out, double z) {
        const bool right = i == 1 || i == 2, up = i >= 2;
        return Vec3(right ? high[0] + out : low[0] - out, up ? high[1] + out : low[1] - out, floor + z);
    };
    for (int i = 0; i < 4; ++i) {
        const int next = (i + 1) % 4;
        scene.line(corner(i, 0, 0), corner(next, 0, 0), kRoomInk, 1.8);
        scene.line(corner(i, 0, options.height), corner(next, 0, options.height), kRoomInk, 1.2);
        scene.line(corner(i, options.thickness, options.height), corner(next, options.thickness, options.height), kRoomInk, 1.2);
        scene.line(corner(i, 0, 0), corner(i, 0, options.height), kRoomInk, 1.2);
    }
    const auto label = [&](const Vec3& at, const QString& text) {
        if (const auto pixel = m_view.shownPixelOf(at)) paintLabel(painter, *pixel, text);
    };
    label({(low[0] + high[0]) / 2, low[1], floor}, m_typed.shown(false, metres(high[0] - low[0])));
    label({high[0], (low[1] + high[1]) / 2, floor}, m_typed.shown(true, metres(high[1] - low[1])));
}

} // namespace trundle
