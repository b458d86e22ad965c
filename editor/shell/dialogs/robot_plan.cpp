#include "editor/shell/dialogs/robot_plan.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <QPainter>

#include "editor/widgets/painted_icon.h"
#include "editor/widgets/theme.h"

namespace trundle {
namespace {

constexpr double kSteeredDeg = 20; // in the picture
const QColor kHull(0xe8, 0x8a, 0x2a);

/// A wheel seen from above.
struct PlanWheel {
    QPointF centre;     ///< m, ahead and to the left
    double heading = 0; ///< degrees, of the direction in which it rolls
    double rollers = 0; ///< degrees against its axle, of a mecanum wheel; 0: without rollers
};

std::vector<PlanWheel> wheelsOf(const RobotDesign& d) {
    const double half = d.wheelSeparation / 2, ahead = d.wheelBase / 2;
    switch (d.base) {
    case BaseShape::Differential: return {{{0, half}}, {{0, -half}}};
    case BaseShape::SkidSteer: return {{{ahead, half}}, {{ahead, -half}}, {{-ahead, half}}, {{-ahead, -half}}};
    case BaseShape::Mecanum:
        return {{{ahead, half}, 0, -45}, {{ahead, -half}, 0, 45}, {{-ahead, half}, 0, 45}, {{-ahead, -half}, 0, -45}};
    case BaseShape::Ackermann:
        return {{{0, half}}, {{0, -half}}, {{d.wheelBase, half}, kSteeredDeg}, {{d.wheelBase, -half}, kSteeredDeg}};
    case BaseShape::Omni: break;
    }
    std::vector<PlanWheel> wheels;
    for (const double heading : {60., 180., 300.}) {
        const double a = heading * std::numbers::pi / 180;
        wheels.push_back({{half * std::cos(a), half * std::sin(a)}, heading + 90});
    }
    return wheels;
}

/// m, of the middle of the hull ahead of the origin of the robot.
double hullAhead(const RobotDesign& d) {
    return d.base == BaseShape::Differential ? -0.2 * d.length : d.base == BaseShape::Ackermann ? d.wheelBase / 2 : 0;
}

QRectF hullFromAbove(const RobotDesign& d) {
    const double length = d.base == BaseShape::Omni ? d.width : d.length;
    return {hullAhead(d) - length / 2, -d.width / 2, length, d.width};
}

/// All that is seen from above, m.
QRectF extentOf(const RobotDesign& d) {
    QRectF all = hullFromAbove(d);
    const double r = d.wheelRadius, w = wheelWidth(d) / 2;
    for (const PlanWheel& wheel : wheelsOf(d)) {
        const double a = wheel.heading * std::numbers::pi / 180;
        const QPointF reach(std::abs(r * std::cos(a)) + std::abs(w * std::sin(a)),
                            std::abs(r * std::sin(a)) + std::abs(w * std::cos(a)));
        all = all.united(QRectF(wheel.centre - reach, wheel.centre + reach));
    }
    return all;
}

/// Maps metres, ahead to the right and left up, to pixels.
struct Map {
    QPointF origin;   ///< pixels
    double scale = 1; ///< pixels per metre

    [[nodiscard]] QPointF operator()(double x, double y) const { return {origin.x() + x * scale, origin.y() - y * scale}; }
    [[nodiscard]] QRectF operator()(const QRectF& r) const {
        return QRectF((*this)(r.left(), r.bottom()), (*this)(r.right(), r.top())).normalized();
    }
};

void paintWheel(QPainter& p, const Map& at, const RobotDesign& d, const PlanWheel& wheel) {
    p.save();
    p.translate(at(wheel.centre.x(), wheel.centre.y()));
    p.rotate(-wheel.heading);
    const double length = 2 * d.wheelRadius * at.scale, width = std::max(2., wheelWidth(d) * at.scale);
    const QRectF tyre(-length / 2, -width / 2, length, width);
    p.setPen(Qt::NoPen);
    p.setBrush(ink(Ink::Text));
    p.drawRoundedRect(tyre, width / 5, width / 5);
    if (wheel.rollers != 0) { // as seen from above: the rollers that are on top
        p.setClipRect(tyre);
        p.setPen(QPen(themePalette().color(QPalette::Base), std::max(1., width / 8)));
        for (double x = -length; x <= length; x += length / 5)
            p.drawLine(QPointF(x - width / 2 * (wheel.rollers > 0 ? 1 : -1), -width / 2),
                       QPointF(x + width / 2 * (wheel.rollers > 0 ? 1 : -1), width / 2));
    }
    p.restore();
}

void paintFromAbove(QPainter& p, const Map& at, const RobotDesign& d) {
    const QRectF hull = at(hullFromAbove(d));
    p.setPen(QPen(kHull.darker(140), 1));
    p.setBrush(kHull);
    if (d.base == BaseShape::Omni) p.drawEllipse(hull);
    else p.drawRoundedRect(hull, 2, 2);
    p.setPen(Qt::NoPen);
    p.setBrush(Qt::white);
    const double stripe = std::max(2., hull.width() * 0.05);
    p.drawRect(QRectF(hull.right() - (d.base == BaseShape::Omni ? 0.18 : 0.08) * hull.width() - stripe / 2,
                      hull.center().y() - hull.height() / 4, stripe, hull.height() / 2));
    if (d.base == BaseShape::Differential) {
        const double r = groundClearance(d) / 2 * at.scale;
        p.setPen(QPen(ink(Ink::Text), 1, Qt::DotLine));
        p.setBrush(Qt::NoBrush);
        p.drawEllipse(at(-0.6 * d.length, 0), r, r);
    }
    for (const PlanWheel& wheel : wheelsOf(d)) paintWheel(p, at, d, wheel);
}

void paintFromTheSide(QPainter& p, const Map& at, const RobotDesign& d) {
    const QRectF seen = extentOf(d), above = hullFromAbove(d);
    p.setPen(QPen(ink(Ink::Faint), 1));
    p.drawLine(at(seen.left(), 0), at(seen.right(), 0));
    p.setPen(QPen(kHull.darker(140), 1));
    p.setBrush(kHull);
    p.drawRoundedRect(at(QRectF(above.left(), groundClearance(d), above.width(), d.height)), 2, 2);
    for (const PlanWheel& wheel : wheelsOf(d)) {
        const double a = wheel.heading * std::numbers::pi / 180, r = d.wheelRadius;
        const double half = d.base == BaseShape::Omni ? std::max(std::abs(r * std::cos(a)), wheelWidth(d) / 2) : r;
        p.setPen(QPen(themePalette().color(QPalette::Base), 1));
        p.setBrush(ink(Ink::Text));
        p.drawEllipse(at(QRectF(wheel.centre.x() - half, 0, 2 * half, 2 * r)));
    }
    if (d.base == BaseShape::Differential) {
        const double r = groundClearance(d) / 2;
        p.drawEllipse(at(QRectF(-0.6 * d.length - r, 0, 2 * r, 2 * r)));
    }
}

/// A line with ends, and its length beside it.
class Dimension {
public:
    Dimension(QPainter& painter, bool isHighlighted) : m_painter(painter) {
        painter.setPen(QPen(ink(isHighlighted ? Ink::Accent : Ink::Faint), isHighlighted ? 2 : 1));
    }
    /// Ends at the pixels `from` and `to` on x; the text is below.
    void horizontal(double from, double to, double y, double metres) const {
        m_painter.drawLine(QPointF(from, y), QPointF(to, y));
        for (const double x : {from, to}) m_painter.drawLine(QPointF(x, y - 4), QPointF(x, y + 4));
        label(QPointF((from + to) / 2, y + 3), metres, Qt::AlignHCenter | Qt::AlignTop);
    }
    void vertical(double x, double from, double to, double metres) const {
        m_painter.drawLine(QPointF(x, from), QPointF(x, to));
        for (const double y : {from, to}) m_painter.drawLine(QPointF(x - 4, y), QPointF(x + 4, y));
        label(QPointF(x + 7, (from + to) / 2), metres, Qt::AlignLeft | Qt::AlignVCenter);
    }
    void label(const QPointF& at, double metres, Qt::Alignment alignment) const {
        const QSizeF room(200, 40);
        QRectF box(at, room);
        if (alignment & Qt::AlignHCenter) box.moveLeft(at.x() - room.width() / 2);
        if (alignment & Qt::AlignVCenter) box.moveTop(at.y() - room.height() / 2);
        m_painter.drawText(box, int(alignment), QStringLiteral("%1 m").arg(metres, 0, 'g', 4));
    }

private:
    QPainter& m_painter;
};

} // namespace

RobotPlan::RobotPlan(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("robotPlan"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    useFont(*this, [] { return figuresFont(11); });
}

void RobotPlan::show(const RobotDesign& design) {
    m_design = design;
    update();
}

void RobotPlan::highlight(double RobotDesign::*number) {
    m_highlighted = number;
    update();
}

QSize RobotPlan::sizeHint() const { return {scaledToFont(300), scaledToFont(250)}; }
QSize RobotPlan::minimumSizeHint() const { return {220, 200}; }

void RobotPlan::paintEvent(QPaintEvent*) {
    QPainter p(this);
    p.setRenderHint(QPainter::Antialiasing);
    p.setFont(font());
    p.setPen(QPen(ink(Ink::Line), 1));
    p.setBrush(themePalette().color(QPalette::Base));
    p.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);

    const RobotDesign& d = m_design;
    const QRectF seen = extentOf(d);
    const double high = std::max(groundClearance(d) + d.height, 2 * d.wheelRadius), line = fontMetrics().lineSpacing();
    const double beside = 7 + 1.2 * fontMetrics().horizontalAdvance(QStringLiteral("0.000 m")), margin = 12,
                 between = 2 * line + 16;
    const double scale = std::min((width() - 2 * margin - beside - 12) / seen.width(),
                                  (height() - 2 * margin - 2 * between - 6) / (seen.height() + high));
    if (!(scale > 0) || !std::isfinite(scale)) return;
    const double left = margin + (width() - 2 * margin - beside - seen.width() * scale) / 2;
    const double free = height() - 2 * margin - 2 * between - scale * (seen.height() + high);
    const double top = margin + free / 3;
    const Map above{{left - seen.left() * scale, top + seen.bottom() * scale}, scale};
    const Map side{{above.origin.x(), top + seen.height() * scale + between + free / 3 + high * scale}, scale};
    paintFromAbove(p, above, d);
    paintFromTheSide(p, side, d);

    const auto dimension = [&](double RobotDesign::*number) { return Dimension(p, m_highlighted == number); };
    const QRectF hull = above(hullFromAbove(d));
    const double right = above(seen.right(), 0).x() + 8, below = above(0, seen.top()).y() + 8;
    dimension(&RobotDesign::wheelSeparation)
        .vertical(right, above(0, d.wheelSeparation / 2).y(), above(0, -d.wheelSeparation / 2).y(), d.wheelSeparation);
    if (d.base != BaseShape::Omni) {
        dimension(&RobotDesign::length).horizontal(hull.left(), hull.right(), below, d.length);
        p.setPen(QPen(m_highlighted == &RobotDesign::width ? ink(Ink::Accent) : QColor(Qt::white), 1));
    } else {
        p.setPen(QPen(m_highlighted == &RobotDesign::width ? ink(Ink::Accent) : QColor(Qt::white), 1));
    }
    p.drawText(hull, Qt::AlignCenter, tr("%1 m\nwide").arg(d.width, 0, 'g', 4));
    const double floor = side(0, 0).y();
    dimension(&RobotDesign::height)
        .vertical(right, side(0, groundClearance(d) + d.height).y(), side(0, groundClearance(d)).y(), d.height);
    if (hasWheelBase(d.base)) {
        const double from = d.base == BaseShape::Ackermann ? 0 : -d.wheelBase / 2;
        dimension(&RobotDesign::wheelBase).horizontal(side(from, 0).x(), side(from + d.wheelBase, 0).x(), floor + 8, d.wheelBase);
    } else {
        const double from = d.base == BaseShape::Omni ? wheelsOf(d)[1].centre.x() : 0;
        dimension(&RobotDesign::wheelRadius)
            .horizontal(side(from - d.wheelRadius, 0).x(), side(from + d.wheelRadius, 0).x(), floor + 8, 2 * d.wheelRadius);
    }
}

QIcon baseIcon(BaseShape base) {
    return paintedIcon([base](QPainter& p, const QRectF& box, QIcon::Mode) {
        p.setRenderHint(QPainter::Antialiasing);
        const RobotDesign design = usualDesign(base);
        const QRectF seen = extentOf(design);
        const double scale = 0.94 * std::min(box.width() / seen.width(), box.height() / seen.height());
        const QPointF middle = box.center() - QPointF(seen.center().x(), -seen.center().y()) * scale;
        paintFromAbove(p, Map{middle, scale}, design);
    });
}

} // namespace trundle
