#include "editor/viewport/gizmo/gizmo_drag.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <QCoreApplication>
#include <QKeyEvent>

#include "lang/number_text.h"
#include "project/objects/typed_number.h"

namespace trundle {
namespace {

constexpr double kEdgeOn = 0.15;       // cosine between ring normal and line of sight; below it the ring is edge-on
constexpr double kRadPerPixel = 0.013; // for an edge-on ring
constexpr double kReach = 2000;        // m; limit for planes seen at a grazing angle

double snapped(double value, double step) { return step > 0 ? step * std::round(value / step) : value; }

} // namespace

GizmoDrag::GizmoDrag(const GizmoHandle& handle, const GizmoPose& place, const ViewRay& start, const QPointF& pixel)
    : m_handle(handle), m_place(place), m_startPixel(pixel) {
    m_edgeOn = handle.kind == GizmoHandle::Kind::Ring && std::abs(place.axes.col(handle.axis).dot(place.forward)) < kEdgeOn;
    m_start = place.origin;
    m_start = pointOf(start);
    m_lastAngle = angleOf(m_start);
}

/// The point on the handle's line or plane that is nearest to the ray; the start point if there is none.
Vec3 GizmoDrag::pointOf(const ViewRay& ray) const {
    const Vec3 axis = m_place.axes.col(m_handle.axis);
    if (m_handle.kind == GizmoHandle::Kind::Axis || m_handle.kind == GizmoHandle::Kind::Size) {
        const Vec3 between = m_place.origin - ray.origin;
        const double b = axis.dot(ray.direction), d = axis.dot(between), e = ray.direction.dot(between), n = 1 - b * b;
        if (n < 1e-6) return m_start;
        const double along = (b * e - d) / n;
        return std::abs(along) > kReach ? m_start : Vec3(m_place.origin + along * axis);
    }
    const Vec3 normal = m_handle.kind == GizmoHandle::Kind::Screen ? m_place.forward : axis;
    const double towards = normal.dot(ray.direction);
    if (std::abs(towards) < 1e-6) return m_start;
    const double far = normal.dot(m_place.origin - ray.origin) / towards;
    if (far < 0 || far > kReach) return m_start;
    return ray.origin + far * ray.direction;
}

double GizmoDrag::angleOf(const Vec3& point) const {
    const Vec3 out = point - m_place.origin;
    return std::atan2(out.dot(m_place.axes.col((m_handle.axis + 2) % 3)), out.dot(m_place.axes.col((m_handle.axis + 1) % 3)));
}

void GizmoDrag::to(const ViewRay& ray, const QPointF& pixel, double moveStep, double rotationStep, bool aboutCentre) {
    m_aboutCentre = aboutCentre;
    if (m_handle.kind == GizmoHandle::Kind::Ring) {
        if (m_edgeOn) {
            m_turned = kRadPerPixel * (pixel.x() - m_startPixel.x());
        } else {
            const double angle = angleOf(pointOf(ray));
            m_turned += std::remainder(angle - m_lastAngle, 2 * std::numbers::pi);
            m_lastAngle = angle;
        }
        m_degrees = snapped(m_turned * 180 / std::numbers::pi, rotationStep);
        return;
    }
    const Vec3 by = m_place.axes.transpose() * (pointOf(ray) - m_start);
    for (int k = 0; k < 3; ++k) {
        const double size = m_handle.kind == GizmoHandle::Kind::Size ? m_place.sizes[k].ofHalf : 1;
        const double outward = m_handle.kind == GizmoHandle::Kind::Size ? m_handle.side : 1;
        const double share = isOneSided() ? 0.5 : 1; // the side follows the mouse, the centre moves half as far
        m_unsnapped[k] = isAlong(k) ? outward * share * by[k] : 0;
        m_amount[k] = snapped(size * m_unsnapped[k], moveStep) / size;
    }
}

bool GizmoDrag::isAlong(int axis) const {
    return m_handle.kind == GizmoHandle::Kind::Screen || (m_handle.kind == GizmoHandle::Kind::Plane) != (axis == m_handle.axis);
}

int GizmoDrag::axisCount() const {
    return m_handle.kind == GizmoHandle::Kind::Screen ? 3 : m_handle.kind == GizmoHandle::Kind::Plane ? 2 : 1;
}

/// Any character is taken, so that none is lost from what is meant.
bool GizmoDrag::type(int key, const QString& text) {
    const bool isBlank = m_typed.empty() && text == QLatin1String(" ");
    if (key != Qt::Key_Backspace && (text.size() != 1 || !text[0].isPrint() || isBlank)) return false;
    QString typed = QString::fromStdString(m_typed);
    if (key == Qt::Key_Backspace) typed.chop(1);
    else typed += text;
    m_typed = typed.toStdString();
    read();
    return true;
}

/// What is typed, as for a property row.
Property GizmoDrag::typedProperty() const {
    const bool turns = m_handle.kind == GizmoHandle::Kind::Ring, sizes = m_handle.kind == GizmoHandle::Kind::Size;
    Property property;
    property.name = turns ? "the angle" : sizes ? m_place.sizes[m_handle.axis].name.toStdString() : "the distance";
    property.unit = turns ? "deg" : "m";
    property.maximum = std::numeric_limits<double>::infinity();
    property.minimum = sizes ? 0 : -property.maximum;
    property.minExclusive = sizes;
    return property;
}

void GizmoDrag::read() {
    m_numbers.reset();
    m_fault.clear();
    if (m_typed.empty()) return;
    const QStringList parts = QString::fromStdString(m_typed).split(QLatin1Char(','));
    if (parts.size() > axisCount()) {
        m_fault = axisCount() == 1 ? QCoreApplication::translate("GizmoDrag", "One number, with a point for decimals")
                                   : QCoreApplication::translate("GizmoDrag", "No more than %1 numbers").arg(axisCount());
        return;
    }
    const Property property = typedProperty();
    Vec3 numbers = Vec3::Zero();
    for (int k = 0; k < parts.size() && m_fault.isEmpty(); ++k) {
        if (parts[k].trimmed().isEmpty()) continue; // left out: 0
        const Result<double> number = typedNumber(parts[k].toStdString(), property);
        if (number) numbers[k] = number.value();
        else m_fault = QString::fromStdString(number.error().message);
    }
    if (m_fault.isEmpty()) m_numbers = numbers;
}

Vec3 GizmoDrag::amount() const {
    const std::optional<Vec3>& typed = m_numbers;
    if (!typed) return m_amount;
    Vec3 amount = Vec3::Zero();
    if (m_handle.kind == GizmoHandle::Kind::Screen) return *typed;
    if (m_handle.kind == GizmoHandle::Kind::Plane) {
        // The plane's two axes in the order x, y, z.
        int next = 0;
        for (int k = 0; k < 3; ++k)
            if (k != m_handle.axis) amount[k] = (*typed)[next++];
        return amount;
    }
    amount[m_handle.axis] = typed->x();
    if (m_handle.kind != GizmoHandle::Kind::Size) return amount;
    // The value typed is the size itself, as in the property row.
    amount[m_handle.axis] = typed->x() / m_place.sizes[m_handle.axis].ofHalf - m_place.half[m_handle.axis];
    return amount;
}

double GizmoDrag::degrees() const { return m_numbers ? m_numbers->x() : m_degrees; }

bool GizmoDrag::isOneSided() const {
    if (m_handle.kind != GizmoHandle::Kind::Size) return false;
    const Sides sides = m_place.sizes[m_handle.axis].sides;
    return sides == Sides::Upper || sides == Sides::Lower || (sides == Sides::Both && !m_aboutCentre);
}

Pose GizmoDrag::motion() const {
    if (m_handle.kind == GizmoHandle::Kind::Size)
        return {isOneSided() ? Vec3(m_handle.side * (m_place.axes * amount())) : Vec3::Zero(), Quat::Identity()};
    if (m_handle.kind != GizmoHandle::Kind::Ring) return {m_place.axes * amount(), Quat::Identity()};
    const Vec3 axis = m_place.axes.col(m_handle.axis);
    const Quat turn(Eigen::AngleAxisd(degrees() * std::numbers::pi / 180, axis));
    return {m_place.origin - turn * m_place.origin, turn};
}

QString GizmoDrag::readOut() const {
    static constexpr const char* kNames[] = {"X", "Y", "Z"};
    const auto number = [](double value, double step) { return QString::fromStdString(steppedNumber(value, step)); };
    QString text;
    if (m_handle.kind == GizmoHandle::Kind::Ring) {
        text = QStringLiteral("%1  %2°").arg(QLatin1String(kNames[m_handle.axis]), number(degrees(), 0.01));
    } else if (m_handle.kind == GizmoHandle::Kind::Size) {
        const SizeName& size = m_place.sizes[m_handle.axis];
        const double now = size.ofHalf * (m_place.half[m_handle.axis] + amount()[m_handle.axis]);
        text = QStringLiteral("%1  %2 m").arg(size.name, number(std::max(0.0, now), 1e-4));
    } else {
        const Vec3 by = amount();
        for (int k = 0; k < 3; ++k) {
            if (!isAlong(k)) continue;
            if (!text.isEmpty()) text += QStringLiteral("   ");
            text += QStringLiteral("%1  %2 m").arg(QLatin1String(kNames[k]), number(by[k], 1e-4));
        }
    }
    return m_typed.empty() ? text : text + QStringLiteral("   › ") + QString::fromStdString(m_typed);
}

} // namespace trundle
