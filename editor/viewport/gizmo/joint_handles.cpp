#include "editor/viewport/gizmo/joint_handles.h"

#include <cmath>
#include <numbers>
#include <utility>

#include <QCoreApplication>
#include <QPainter>
#include <QWidget>

#include "editor/viewport/context/scene_painter.h"
#include "editor/viewport/context/tool_view.h"
#include "editor/widgets/theme.h"
#include "lang/number_text.h"

namespace trundle {
namespace {

constexpr double kArrowPixels = 88;
constexpr double kHandlePixels = 6.5, kReachPixels = 10;
constexpr double kFreeTravel = 0.4;                // where the handle of a travel without an end is, as part of the arrow
constexpr double kFreeStop = std::numbers::pi / 2; // where the handle of an angle without a stop is, to each side
const QColor kJointInk(214, 92, 214), kSecondInk(110, 170, 250), kHotInk(255, 208, 60), kHandleRim(10, 12, 16, 200),
    kStopInk(255, 190, 90);

QString trHandle(const char* text) { return QCoreApplication::translate("JointHandles", text); }
QString shownNumber(double value, double step) { return QString::fromStdString(steppedNumber(value, step)); }

} // namespace

JointHandles::JointHandles(const EditedJoint& joint, const ToolView& view, bool asShown)
    : m_joint(joint), m_view(view), m_asShown(asShown) {
    const Vec3 at = joint.X_WC() * joint.spec().anchor;
    m_length = kArrowPixels * view.camera().free().metresPerPixel(view.widget().width(), at);
    if (joint.spec().type == JointType::Fixed) return;
    for (const bool second : {false, true}) {
        if (second && !joint.hasSecondAxis()) continue;
        if (joint.hasStops(second)) addStops(second);
        add({JointHandle::Kind::Axis, {false, second}}, joint.spec().anchor + m_length * joint.axis(second));
    }
    if (joint.canMoveAnchor()) add({JointHandle::Kind::Anchor, {}}, joint.spec().anchor);
    addLimits();
}

/// Of a Ball how far it swings, of a Suspension how far it travels to both sides.
void JointHandles::addLimits() {
    const JointSpec& spec = m_joint.spec();
    if (spec.type == JointType::Ball)
        add({JointHandle::Kind::Swing, {}}, onCone(spec.swingStop.value_or(kFreeStop), 0), spec.swingStop.has_value());
    if (spec.type != JointType::Suspension) return;
    const double travel = spec.travel > 0 ? spec.travel : kFreeTravel * m_length;
    for (const bool isHigh : {false, true})
        add({JointHandle::Kind::Travel, {isHigh, false}}, spec.anchor + (isHigh ? travel : -travel) * spec.axis, spec.travel > 0);
}

Vec3 JointHandles::onCone(double swing, double around) const {
    const Vec3& axis = m_joint.axis(false);
    const Vec3 zero = m_joint.zeroDirection(axis);
    const Vec3 out = std::cos(around) * zero + std::sin(around) * axis.cross(zero);
    return m_joint.spec().anchor + kCirclePart * m_length * (std::cos(swing) * axis + std::sin(swing) * out);
}

void JointHandles::add(const JointHandle& handle, const Vec3& p_C, bool isSet) {
    const Vec3 p_W = m_joint.X_WC() * p_C;
    if (const auto at = m_asShown ? m_view.shownPixelOf(p_W) : m_view.camera().pixelOf(p_W))
        m_spots.push_back({handle, *at, isSet});
}

Vec3 JointHandles::onCircle(double angle, bool second) const {
    const Vec3& axis = m_joint.axis(second);
    const Vec3 zero = m_joint.zeroDirection(axis), across = axis.cross(zero);
    return m_joint.spec().anchor + kCirclePart * m_length * (std::cos(angle) * zero + std::sin(angle) * across);
}

/// The value of a stop, or else where its handle is.
double JointHandles::shownStop(const JointStop& stop) const {
    if (const auto value = m_joint.stop(stop)) return *value;
    const auto other = m_joint.stop({!stop.isHigh, stop.isSecond});
    const double free = m_joint.turns() ? kFreeStop : kCirclePart * m_length;
    return stop.isHigh ? std::max(free, other.value_or(0) + 0.5 * free) : std::min(-free, other.value_or(0) - 0.5 * free);
}

void JointHandles::addStops(bool second) {
    for (const bool isHigh : {false, true}) {
        const JointStop stop{isHigh, second};
        const double value = shownStop(stop);
        add({JointHandle::Kind::Stop, stop},
            m_joint.turns() ? onCircle(value, second) : Vec3(m_joint.spec().anchor + value * m_joint.axis(false)),
            m_joint.stop(stop).has_value());
    }
}

JointHandle JointHandles::hit(const QPointF& at) const {
    JointHandle nearest;
    double best = kReachPixels;
    for (const Spot& spot : m_spots)
        if (const double distance = QLineF(spot.at, at).length(); distance <= best) best = distance, nearest = spot.handle;
    return nearest;
}

std::optional<QPointF> JointHandles::spot(const JointHandle& handle) const {
    for (const Spot& spot : m_spots)
        if (spot.handle == handle) return spot.at;
    return std::nullopt;
}

QString JointHandles::label(const JointHandle& handle) const {
    const JointSpec& joint = m_joint.spec();
    const auto triple = [](const Vec3& v, double step) {
        return QStringLiteral("%1, %2, %3").arg(shownNumber(v.x(), step), shownNumber(v.y(), step), shownNumber(v.z(), step));
    };
    switch (handle.kind) {
    case JointHandle::Kind::Anchor: return trHandle("Anchor %1 m").arg(triple(joint.anchor, 1e-4));
    case JointHandle::Kind::Axis:
        return (handle.stop.isSecond ? trHandle("Axis2 %1") : trHandle("Axis %1"))
            .arg(triple(m_joint.axis(handle.stop.isSecond), 1e-3));
    case JointHandle::Kind::Stop: {
        const QString name =
            QString(QLatin1String(handle.stop.isHigh ? "HighStop" : "LowStop")) + QLatin1String(handle.stop.isSecond ? "2" : "");
        const auto value = m_joint.stop(handle.stop);
        if (!value) return trHandle("No %1: drag to set it").arg(name);
        return m_joint.turns() ? QStringLiteral("%1 %2°").arg(name, shownNumber(*value * 180 / std::numbers::pi, 0.1))
                               : QStringLiteral("%1 %2 m").arg(name, shownNumber(*value, 1e-4));
    }
    case JointHandle::Kind::Swing:
        return joint.swingStop ? QStringLiteral("SwingStop %1°").arg(shownNumber(*joint.swingStop * 180 / std::numbers::pi, 0.1))
                               : trHandle("No %1: drag to set it").arg(QLatin1String("SwingStop"));
    case JointHandle::Kind::Travel:
        return joint.travel > 0 ? QStringLiteral("Travel %1 m").arg(shownNumber(joint.travel, 1e-4))
                                : trHandle("No %1: drag to set it").arg(QLatin1String("Travel"));
    case JointHandle::Kind::None: break;
    }
    return {};
}

void JointHandles::paintAxis(QPainter& painter, bool second, bool isHot) const {
    const Vec3 at = m_joint.spec().anchor, along = m_joint.axis(second);
    const QColor colour = isHot ? kHotInk : second ? kSecondInk : kJointInk;
    const ScenePainter scene(painter, m_view);
    scene.line(m_joint.X_WC() * (at - 0.35 * m_length * along), m_joint.X_WC() * (at + m_length * along), colour,
               isHot ? 3 : 2.2);
}

/// The part of the circle, or of the line, that the stops leave.
void JointHandles::paintRange(QPainter& painter, bool second) const {
    const auto low = m_joint.stop({false, second}), high = m_joint.stop({true, second});
    if (m_joint.turns()) return paintArc(painter, second, low.value_or(-std::numbers::pi), high.value_or(std::numbers::pi));
    const Vec3 at = m_joint.spec().anchor, along = m_joint.axis(false);
    const double from = shownStop({false, false}), to = shownStop({true, false});
    const ScenePainter scene(painter, m_view);
    const bool isOpen = !low || !high;
    scene.line(m_joint.X_WC() * (at + from * along), m_joint.X_WC() * (at + to * along), QColor(255, 190, 90), 3,
               isOpen ? Qt::DotLine : Qt::SolidLine);
}

void JointHandles::paintArc(QPainter& painter, bool second, double low, double high) const {
    constexpr double kStep = 5 * std::numbers::pi / 180;
    const int steps = std::max(1, int(std::ceil((high - low) / kStep)));
    std::vector<Vec3> arc;
    for (int i = 0; i <= steps; ++i) arc.push_back(m_joint.X_WC() * onCircle(low + (high - low) * i / steps, second));
    const ScenePainter scene(painter, m_view);
    const bool isWhole = high - low > 2 * std::numbers::pi - 1e-6;
    if (!isWhole) {
        std::vector<Vec3> sector = arc;
        sector.push_back(m_joint.X_WC() * m_joint.spec().anchor);
        painter.setPen(Qt::NoPen);
        painter.setBrush(QColor(255, 190, 90, 46));
        scene.polygon(sector);
    }
    QPolygonF shown;
    for (const Vec3& point : arc)
        if (const auto at = m_view.shownPixelOf(point)) shown << *at;
    painter.setBrush(Qt::NoBrush);
    for (const auto& [colour, width] : {std::pair(QColor(10, 12, 16, 90), isWhole ? 2.8 : 3.6),
                                        {QColor(255, 190, 90, isWhole ? 170 : 255), isWhole ? 1.2 : 2.0}}) {
        painter.setPen(QPen(colour, width));
        painter.drawPolyline(shown);
    }
    if (!isWhole) // where it starts
        scene.line(m_joint.X_WC() * m_joint.spec().anchor, m_joint.X_WC() * onCircle(0, second), QColor(245, 246, 248), 1,
                   Qt::DashLine);
}

void JointHandles::paintCone(QPainter& painter) const {
    constexpr int kSides = 48;
    if (!m_joint.spec().swingStop) return;
    const ScenePainter scene(painter, m_view);
    std::vector<Vec3> rim;
    for (int i = 0; i < kSides; ++i)
        rim.push_back(m_joint.X_WC() * onCone(*m_joint.spec().swingStop, 2 * std::numbers::pi * i / kSides));
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(255, 190, 90, 40));
    scene.polygon(rim);
    const Vec3 apex = m_joint.X_WC() * m_joint.spec().anchor;
    for (int i = 0; i < kSides; ++i) {
        scene.line(rim[std::size_t(i)], rim[std::size_t(i + 1) % kSides], kStopInk, 1.8);
        if (i % (kSides / 8) == 0) scene.line(apex, rim[std::size_t(i)], kStopInk, 1);
    }
}

void JointHandles::paintTravel(QPainter& painter) const {
    const JointSpec& spec = m_joint.spec();
    const double travel = spec.travel > 0 ? spec.travel : kFreeTravel * m_length;
    ScenePainter(painter, m_view)
        .line(m_joint.X_WC() * (spec.anchor - travel * spec.axis), m_joint.X_WC() * (spec.anchor + travel * spec.axis), kStopInk,
              3, spec.travel > 0 ? Qt::SolidLine : Qt::DotLine);
}

void JointHandles::paint(QPainter& painter, const JointHandle& hot) const {
    if (m_spots.empty()) return;
    if (m_joint.spec().type == JointType::Ball) paintCone(painter);
    if (m_joint.spec().type == JointType::Suspension) paintTravel(painter);
    for (const bool second : {false, true}) {
        if (second && !m_joint.hasSecondAxis()) continue;
        if (m_joint.hasStops(second)) paintRange(painter, second);
        paintAxis(painter, second, hot == JointHandle{JointHandle::Kind::Axis, {false, second}});
    }
    for (const Spot& spot : m_spots) {
        const bool isHot = hot == spot.handle;
        const bool isLimit = spot.handle.kind != JointHandle::Kind::Axis && spot.handle.kind != JointHandle::Kind::Anchor;
        const QColor own = isLimit                                         ? kStopInk
                           : spot.handle.stop.isSecond                     ? kSecondInk
                           : spot.handle.kind == JointHandle::Kind::Anchor ? QColor(245, 246, 248)
                                                                           : kJointInk;
        const QColor colour = isHot ? kHotInk : own;
        painter.setPen(QPen(spot.isSet ? kHandleRim : colour, spot.isSet ? 1.2 : 2));
        painter.setBrush(spot.isSet ? QBrush(colour) : QBrush(QColor(24, 27, 31, 150)));
        const double r = kHandlePixels;
        if (isLimit)
            painter.drawPolygon(
                QPolygonF{spot.at + QPointF(0, -r), spot.at + QPointF(r, 0), spot.at + QPointF(0, r), spot.at + QPointF(-r, 0)});
        else painter.drawEllipse(spot.at, r, r);
    }
}

} // namespace trundle
