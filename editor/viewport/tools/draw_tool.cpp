#include "editor/viewport/tools/draw_tool.h"

#include <cmath>
#include <utility>

#include <QKeyEvent>
#include <QPainter>
#include <QWidget>

#include "editor/viewport/context/label.h"
#include "editor/viewport/context/scene_painter.h"
#include "editor/viewport/context/tool_view.h"
#include "editor/viewport/context/view_settings.h"
#include "editor/viewport/tools/floor_drawing.h"
#include "lang/number_text.h"

namespace trundle {
namespace {

constexpr double kEndPixels = 12;  // an end this near is snapped to
constexpr double kFarthest = 1000; // m, from the camera
const QColor kPathColour(255, 208, 60), kMarkColour(90, 220, 120);

QString number(double value, double step) { return QString::fromStdString(steppedNumber(value, step)); }

Vec3 onFloor(const FloorPoint& point, double z) { return {point[0], point[1], z}; }

} // namespace

DrawTool::DrawTool(ToolView& view) : m_view(view), m_drawing(view.context().drawing) {
    connect(&m_drawing, &FloorDrawing::changed, this, &DrawTool::update);
    connect(&view.context().settings, &ViewSettings::changed, this, &DrawTool::update);
}

bool DrawTool::isUnderWay() const { return m_drawing.isOn() && !m_drawing.corners().empty(); }

/// Nothing above the horizon.
std::optional<FloorSnap> DrawTool::cornerAt(const Pointer& pointer) const {
    const ViewRay ray = m_view.camera().rayAt(pointer.at);
    const double z = m_drawing.floor(), down = ray.direction.z();
    if (std::abs(down) < 1e-9) return std::nullopt;
    const double distance = (z - ray.origin.z()) / down;
    if (distance < 0 || distance > kFarthest) return std::nullopt;
    const Vec3 under = ray.origin + distance * ray.direction;
    const ViewSettings& settings = m_view.context().settings;
    const bool isToggled = pointer.modifiers & (Qt::ControlModifier | Qt::ShiftModifier);
    const bool snaps = settings.snaps() != isToggled;
    if (snaps && m_drawing.typed().empty()) {
        std::vector<FloorPoint> ends = m_drawing.ends();
        if (m_drawing.corners().size() > 1) ends.insert(ends.begin(), m_drawing.corners().begin(), m_drawing.corners().end() - 1);
        for (const FloorPoint& end : ends)
            if (const auto pixel = m_view.camera().pixelOf(onFloor(end, z));
                pixel && QLineF(*pixel, pointer.at).length() < kEndPixels)
                return FloorSnap{end, FloorSnap::To::End};
    }
    FloorSnapOptions options;
    options.step = snaps ? settings.moveStep() : 0;
    options.directions = settings.rotationStep();
    options.length = m_drawing.typedLength();
    options.angle = m_drawing.typedAngle();
    return snapOnFloor({under.x(), under.y()}, m_drawing.corners(), options);
}

bool DrawTool::press(const Pointer& pointer) {
    if (!m_drawing.isOn() || pointer.button != Qt::LeftButton) return false;
    if (pointer.twice) return m_drawing.finish(), true; // the first click has placed its corner
    if (m_drawing.corners().empty() && !m_drawing.begin()) return true;
    m_pointer = pointer;
    if (const auto corner = cornerAt(pointer)) m_drawing.add(corner->point);
    return true;
}

bool DrawTool::hover(const Pointer& pointer) {
    if (!m_drawing.isOn()) return false;
    m_view.hints().setHovered({}, {});
    m_pointer = pointer;
    update();
    return true;
}

void DrawTool::leave() {
    if (!std::exchange(m_pointer, std::nullopt)) return;
    update();
}

void DrawTool::update() {
    m_next = m_drawing.isOn() && m_pointer ? cornerAt(*m_pointer) : std::nullopt;
    showStatus();
    m_view.widget().update();
}

bool DrawTool::needsKey(const QKeyEvent& event) const {
    if (!m_drawing.isOn() || event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)) return false;
    switch (event.key()) {
    case Qt::Key_Escape: return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
    case Qt::Key_Backspace:
    case Qt::Key_Tab: return isUnderWay();
    default: break;
    }
    if (!isUnderWay() || event.text().size() != 1) return false;
    const QChar c = event.text()[0];
    return c.isDigit() || c == u'.' || c == u',' || c == u'-' || !m_drawing.typed().empty();
}

bool DrawTool::key(QKeyEvent& event) {
    if (!needsKey(event)) return false;
    switch (event.key()) {
    case Qt::Key_Escape: return escape(), true;
    case Qt::Key_Return:
    case Qt::Key_Enter: return enter(), true;
    default: break;
    }
    if (!m_drawing.type(event.key(), event.text()) && event.key() == Qt::Key_Backspace) m_drawing.removeLast();
    return true;
}

/// With a typed number the corner is placed there, without one the path ends.
void DrawTool::enter() {
    if (m_drawing.typed().empty()) return m_drawing.finish();
    update();
    if (m_next && (m_drawing.typedLength() || m_drawing.typedAngle())) m_drawing.add(m_next->point);
}

/// The path under way first, then the tool.
void DrawTool::escape() {
    if (isUnderWay()) return m_drawing.clear();
    m_view.context().settings.setTool(Tool::Select);
}

QString DrawTool::readOut() const {
    if (!m_next || m_drawing.corners().empty()) return {};
    const FloorPoint& last = m_drawing.corners().back();
    const double length = std::hypot(m_next->point[0] - last[0], m_next->point[1] - last[1]);
    const TypedNumbers& typed = m_drawing.typed();
    return typed.shown(false, number(length, 1e-3) + tr(" m")) + QStringLiteral("   ") +
           typed.shown(true, number(headingBetween(last, m_next->point), 0.1) + QStringLiteral("°"));
}

void DrawTool::showStatus() {
    if (!m_drawing.isOn()) {
        if (std::exchange(m_hintShown, false)) m_view.hints().setHint({}); // clears only this tool's own hint
        return;
    }
    m_hintShown = true;
    if (!isUnderWay())
        return m_view.hints().setHint(tr("Click the first corner on the floor · Esc leaves · Ctrl toggles snapping"));
    m_view.hints().setHint(
        tr("Click the next corner, or type its length; Tab: the angle · Enter or double click ends · Backspace takes the "
           "last corner back · Esc cancels"));
}

void DrawTool::paint(QPainter& painter) {
    if (!m_drawing.isOn()) return;
    const ScenePainter scene(painter, m_view);
    const std::vector<FloorPoint>& corners = m_drawing.corners();
    for (std::size_t i = 1; i < corners.size(); ++i) paintPiece(scene, corners[i - 1], corners[i]);
    if (m_next && !corners.empty()) paintPiece(scene, corners.back(), m_next->point);
    std::vector<Vec3> dots;
    for (const FloorPoint& corner : corners) dots.push_back(onFloor(corner, m_drawing.floor()));
    scene.dots(dots, kPathColour, 7);
    if (!m_next) return;
    paintSnap(painter, scene);
    const auto at = m_view.shownPixelOf(onFloor(m_next->point, m_drawing.floor()));
    if (const QString text = readOut(); at && !text.isEmpty()) paintLabel(painter, *at + QPointF(0, -24), text);
}

/// The edges of the wall, or of the line.
void DrawTool::paintPiece(const ScenePainter& scene, const FloorPoint& from, const FloorPoint& to) const {
    const FloorPathStyle style = m_drawing.style();
    const double length = std::hypot(to[0] - from[0], to[1] - from[1]), floor = m_drawing.floor();
    if (length < 1e-6) return;
    const Vec3 across(-(to[1] - from[1]) / length * style.thickness / 2, (to[0] - from[0]) / length * style.thickness / 2, 0);
    const Vec3 up(0, 0, style.top), a = onFloor(from, floor), b = onFloor(to, floor);
    const bool isFlat = style.top < style.thickness;
    for (const Vec3& side : {across, Vec3(-across)}) {
        scene.line(a + side, b + side, kPathColour, 1.6);
        if (isFlat) continue;
        scene.line(a + side + up, b + side + up, kPathColour, 1.6);
        scene.line(a + side, a + side + up, kPathColour, 1.6);
        scene.line(b + side, b + side + up, kPathColour, 1.6);
    }
    for (const Vec3& end : {a, b}) {
        scene.line(end - across, end + across, kPathColour, 1.6);
        if (!isFlat) scene.line(end - across + up, end + across + up, kPathColour, 1.6);
    }
}

/// A ring at an end, a square at a right angle, a dotted line along a direction, a cross on the grid.
void DrawTool::paintSnap(QPainter& painter, const ScenePainter& scene) const {
    const Vec3 point = onFloor(m_next->point, m_drawing.floor());
    const auto at = m_view.shownPixelOf(point);
    if (!at) return;
    if (m_next->to == FloorSnap::To::End) {
        painter.setPen(QPen(kMarkColour, 2.5));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(*at, 9, 9);
        return;
    }
    if (m_next->to == FloorSnap::To::RightAngle) paintRightAngle(scene);
    if (m_next->to == FloorSnap::To::Direction && !m_drawing.corners().empty()) {
        const Vec3 last = onFloor(m_drawing.corners().back(), m_drawing.floor());
        scene.line(last, last + 2 * (point - last), kMarkColour, 1, Qt::DotLine);
    }
    painter.setPen(QPen(m_next->to == FloorSnap::To::Nothing ? kPathColour : kMarkColour, 2));
    painter.drawLine(*at - QPointF(6, 0), *at + QPointF(6, 0));
    painter.drawLine(*at - QPointF(0, 6), *at + QPointF(0, 6));
}

void DrawTool::paintRightAngle(const ScenePainter& scene) const {
    const std::vector<FloorPoint>& corners = m_drawing.corners();
    const Vec3 last = onFloor(corners.back(), m_drawing.floor());
    const Vec3 back = onFloor(corners[corners.size() - 2], m_drawing.floor()) - last;
    const Vec3 on = onFloor(m_next->point, m_drawing.floor()) - last;
    const double side = 0.3 * std::min(back.norm(), on.norm());
    if (side < 1e-6) return;
    const Vec3 a = back.normalized() * side, b = on.normalized() * side;
    scene.line(last + a, last + a + b, kMarkColour, 1.6);
    scene.line(last + b, last + a + b, kMarkColour, 1.6);
}

} // namespace trundle
