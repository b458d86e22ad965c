#include "editor/sensors/heading_dial.h"

#include <cmath>
#include <numbers>

#include <QPainter>

#include "editor/widgets/theme.h"

namespace trundle {
namespace {

constexpr int kDialHeight = 120;

QPointF onDial(const QPointF& middle, double heading, double radius) {
    return middle + radius * QPointF(std::cos(heading), -std::sin(heading));
}

} // namespace

HeadingDial::HeadingDial(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("headingDial"));
    setAccessibleName(tr("Heading"));
    setToolTip(tr("Heading from above: x of the world to the right, counter-clockwise"));
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
}

QSize HeadingDial::sizeHint() const { return {200, scaledToFont(kDialHeight)}; }

void HeadingDial::setHeading(std::optional<double> heading, std::optional<double> trueHeading) {
    if (heading == m_heading && trueHeading == m_trueHeading) return;
    m_heading = heading;
    m_trueHeading = trueHeading;
    update();
}

void HeadingDial::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(figuresFont(10));
    const int letters = painter.fontMetrics().height();
    const QPointF middle(0.5 * width(), 0.5 * height());
    const double radius = 0.5 * std::min(width(), height()) - letters;
    painter.setPen(QPen(ink(Ink::Line), 1.4));
    painter.setBrush(palette().color(QPalette::AlternateBase));
    painter.drawEllipse(middle, radius, radius);
    for (int degrees = -180; degrees < 180; degrees += 30) {
        const double heading = degrees * std::numbers::pi / 180;
        painter.setPen(QPen(ink(Ink::Faint), 1));
        painter.drawLine(onDial(middle, heading, radius - (degrees % 90 ? 4 : 8)), onDial(middle, heading, radius));
        if (degrees % 90) continue;
        const QString text = tr("%1°").arg(degrees == -180 ? 180 : degrees);
        QRectF box(0, 0, painter.fontMetrics().horizontalAdvance(text), letters);
        box.moveCenter(onDial(middle, heading, radius + (degrees % 180 ? 0.5 * letters : 0.5 * box.width() + 3)));
        painter.drawText(box, Qt::AlignCenter | Qt::TextDontClip, text);
    }
    const auto needle = [&](const std::optional<double>& heading, Ink colour, double width) {
        if (!heading || !std::isfinite(*heading)) return;
        const QPointF tip = onDial(middle, *heading, radius - 3);
        painter.setPen(QPen(ink(colour), width, Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(middle, tip);
        painter.drawLine(tip, onDial(tip, *heading + 2.7, 9));
        painter.drawLine(tip, onDial(tip, *heading - 2.7, 9));
    };
    needle(m_trueHeading, Ink::Good, 1.4);
    needle(m_heading, Ink::Accent, 2.4);
}

} // namespace trundle
