#include "editor/viewport/gizmo/gizmo.h"

#include <cmath>

#include <QLineF>
#include <QPainter>

#include "editor/widgets/theme.h"

namespace trundle {
namespace {

constexpr double kLength = 84, kRing = 74, kPlaneFrom = 20, kPlaneTo = 36, kScreen = 7; // pixels
constexpr double kLineReach = 7; // pixels; hit distance to a line, or to the arrow head at its end
constexpr double kFaceOn = 6;    // pixels added to the hit distance of an arrow along the line of sight
constexpr double kAlongSight = 0.97, kHandleEdgeOn = 0.13;
constexpr int kRingSteps = 72;

QColor axisColour(int axis) { return ink(axis == 0 ? Ink::AxisX : axis == 1 ? Ink::AxisY : Ink::AxisZ); }

double distanceTo(const QPolygonF& line, const QPointF& p) {
    double best = 1e9;
    for (int i = 0; i + 1 < line.size(); ++i) {
        const QPointF a = line[i], along = line[i + 1] - a;
        const double length = QPointF::dotProduct(along, along);
        const double t = length > 0 ? std::clamp(QPointF::dotProduct(p - a, along) / length, 0.0, 1.0) : 0;
        best = std::min(best, QLineF(p, a + t * along).length());
    }
    return best;
}

QPolygonF square(const QPointF& at, double half) { return QRectF(at.x() - half, at.y() - half, 2 * half, 2 * half); }

QPolygonF diamond(const QPointF& at, double half) {
    return QPolygonF{{at.x() - half, at.y()}, {at.x(), at.y() - half}, {at.x() + half, at.y()}, {at.x(), at.y() + half}};
}

} // namespace

Gizmo::Gizmo(Tool tool, const GizmoPose& place, const Projector& project) : m_place(place), m_project(project) {
    if (!project(place.origin)) return;
    for (int axis = 0; axis < 3; ++axis) {
        if (tool == Tool::Rotate) addRing(axis);
        if (tool == Tool::Move) addPlane(axis);
    }
    for (int axis = 0; axis < 3; ++axis) {
        if (tool == Tool::Move) addArrow(axis);
        if (tool != Tool::Scale) continue;
        const Sides sides = place.sizes[axis].sides;
        if (sides == Sides::Both || sides == Sides::Lower) addSize(axis, -1);
        if (sides != Sides::Lower) addSize(axis, 1);
    }
    if (tool == Tool::Move) addScreen();
}

void Gizmo::addArrow(int axis) {
    const Vec3 along = m_place.axes.col(axis);
    if (std::abs(along.dot(m_place.forward)) > kAlongSight) return;
    const auto from = m_project(m_place.origin), to = m_project(m_place.origin + kLength * m_place.metresPerPixel * along);
    if (!from || !to) return;
    const QLineF line(*from, *to);
    if (line.length() < 8) return;
    const QPointF d = (line.p2() - line.p1()) / line.length(), n(-d.y(), d.x());
    const QPointF start = line.p1() + 11 * d, neck = line.p2() - 13 * d;
    m_shapes.push_back({{GizmoHandle::Kind::Axis, axis},
                        axisColour(axis),
                        {QPolygonF{start, neck}},
                        {},
                        {line.p2(), neck + 5.5 * n, neck - 5.5 * n},
                        0.5 * (start + line.p2())});
}

void Gizmo::addPlane(int axis) {
    if (std::abs(m_place.axes.col(axis).dot(m_place.forward)) < kHandleEdgeOn) return;
    const Vec3 u = m_place.axes.col((axis + 1) % 3) * m_place.metresPerPixel,
               v = m_place.axes.col((axis + 2) % 3) * m_place.metresPerPixel;
    QPolygonF face;
    QPointF middle;
    for (const auto& [a, b] :
         {std::pair{kPlaneFrom, kPlaneFrom}, {kPlaneTo, kPlaneFrom}, {kPlaneTo, kPlaneTo}, {kPlaneFrom, kPlaneTo}}) {
        const auto corner = m_project(m_place.origin + a * u + b * v);
        if (!corner) return;
        face << *corner;
        middle += 0.25 * *corner;
    }
    m_shapes.push_back({{GizmoHandle::Kind::Plane, axis}, axisColour(axis), {}, {}, face, middle});
}

void Gizmo::addScreen() {
    const QPointF at = *m_project(m_place.origin);
    m_shapes.push_back({{GizmoHandle::Kind::Screen, 0}, QColor(235, 235, 235), {}, {}, square(at, kScreen), at});
}

void Gizmo::addRing(int axis) {
    const Vec3 u = m_place.axes.col((axis + 1) % 3), v = m_place.axes.col((axis + 2) % 3);
    const double radius = kRing * m_place.metresPerPixel;
    Shape shape{{GizmoHandle::Kind::Ring, axis}, axisColour(axis), {}, {}, {}, {}};
    QPolygonF run;
    bool runInFront = true;
    double best = -2;
    for (int i = 0; i <= kRingSteps; ++i) {
        const double angle = 2 * std::numbers::pi * i / kRingSteps;
        const Vec3 out = std::cos(angle) * u + std::sin(angle) * v;
        const auto at = m_project(m_place.origin + radius * out);
        if (!at) return;
        const double towards = -out.dot(m_place.forward);
        const bool inFront = towards > -0.05;
        if (towards > best) best = towards, shape.spot = *at;
        if (!run.isEmpty() && inFront != runInFront) {
            run << *at;
            (runInFront ? shape.lines : shape.faint).push_back(run);
            run.clear();
        }
        runInFront = inFront;
        run << *at;
    }
    (runInFront ? shape.lines : shape.faint).push_back(run);
    m_shapes.push_back(std::move(shape));
}

void Gizmo::addSize(int axis, int side) {
    if (m_place.half[axis] <= 0) return;
    const Vec3 along = side * m_place.axes.col(axis);
    if (std::abs(along.dot(m_place.forward)) > kAlongSight) return;
    const auto from = m_project(m_place.origin),
               to = m_project(m_place.origin + (m_place.half[axis] + m_place.margin + 26 * m_place.metresPerPixel) * along);
    if (!from || !to || QLineF(*from, *to).length() < 8) return;
    // The line of a layout's extent ends at its edge, so that it does not cover the handles of the first member.
    const auto start = m_place.layout ? m_project(m_place.origin + (m_place.half[axis] + m_place.margin) * along) : from;
    if (!start) return;
    const GizmoHandle handle{GizmoHandle::Kind::Size, axis, side, m_place.layout};
    const QPolygonF face = m_place.layout ? diamond(*to, 7.5) : square(*to, 5.5);
    m_shapes.push_back({handle, axisColour(axis), {QPolygonF{*start, *to}}, {}, face, *to});
}

GizmoHandle Gizmo::hit(const QPointF& at) const {
    for (auto shape = m_shapes.rbegin(); shape != m_shapes.rend(); ++shape)
        if (shape->face.containsPoint(at, Qt::WindingFill) && shape->handle.kind != GizmoHandle::Kind::Plane)
            return shape->handle;
    GizmoHandle nearest;
    double best = 1e9;
    for (const Shape& shape : m_shapes) {
        std::vector<QPolygonF> lines = shape.lines;
        if (shape.handle.kind == GizmoHandle::Kind::Axis || shape.handle.kind == GizmoHandle::Kind::Size)
            lines.push_back(shape.face);
        for (const QPolygonF& line : lines) {
            const double distance = distanceTo(line, at);
            // Of overlapping arrows, the one that is more perpendicular to the line of sight is preferred.
            const double score = distance + (shape.handle.kind == GizmoHandle::Kind::Axis
                                                 ? kFaceOn * std::abs(m_place.axes.col(shape.handle.axis).dot(m_place.forward))
                                                 : 0);
            if (distance < kLineReach && score < best) best = score, nearest = shape.handle;
        }
    }
    if (nearest) return nearest;
    // Planes can overlap; the one whose centre is closest is hit.
    best = 1e9;
    for (const Shape& shape : m_shapes) {
        const double distance = QLineF(shape.spot, at).length();
        if (distance < best && shape.face.containsPoint(at, Qt::WindingFill)) best = distance, nearest = shape.handle;
    }
    return nearest;
}

std::optional<QPointF> Gizmo::spot(const GizmoHandle& handle) const {
    for (const Shape& shape : m_shapes)
        if (shape.handle == handle) return shape.spot;
    return std::nullopt;
}

void Gizmo::paint(QPainter& painter, const GizmoHandle& hot, bool dragged) const {
    for (const Shape& shape : m_shapes) {
        const bool isHot = hot == shape.handle;
        if (dragged && !isHot) continue;
        const QColor colour = isHot ? QColor(255, 208, 60) : shape.colour;
        const double width = isHot ? 3 : 2.2;
        QColor faded = colour;
        faded.setAlpha(70);
        painter.setBrush(Qt::NoBrush);
        for (const QPolygonF& line : shape.faint) {
            painter.setPen(QPen(faded, 1.4));
            painter.drawPolyline(line);
        }
        for (const QPolygonF& line : shape.lines) {
            painter.setPen(QPen(QColor(10, 12, 16, 90), width + 2, Qt::SolidLine, Qt::RoundCap));
            painter.drawPolyline(line);
            painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::RoundCap));
            painter.drawPolyline(line);
        }
        if (shape.face.isEmpty()) continue;
        QColor fill = colour;
        if (shape.handle.kind == GizmoHandle::Kind::Plane) fill.setAlpha(isHot ? 190 : 110);
        if (shape.handle.kind == GizmoHandle::Kind::Screen) fill.setAlpha(isHot ? 220 : 120);
        painter.setPen(QPen(shape.handle.kind == GizmoHandle::Kind::Plane ? colour : QColor(10, 12, 16, 120), 1));
        painter.setBrush(fill);
        painter.drawPolygon(shape.face);
    }
}

} // namespace trundle
