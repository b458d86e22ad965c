#include "editor/sensors/battery_gauge.h"

#include <algorithm>
#include <cmath>

#include <QPainter>

#include "editor/widgets/theme.h"

namespace trundle {
namespace {

constexpr int kGaugeHeight = 30;
constexpr double kLow = 0.2, kAlmostEmpty = 0.1;

} // namespace

BatteryGauge::BatteryGauge(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("batteryGauge"));
    setAccessibleName(tr("Charge"));
    setToolTip(tr("Share of the capacity that is left"));
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
}

QSize BatteryGauge::sizeHint() const { return {200, scaledToFont(kGaugeHeight)}; }

void BatteryGauge::setLevel(std::optional<double> level) {
    if (level == m_level) return;
    m_level = level;
    update();
}

void BatteryGauge::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF body(1, 3, width() - 8, height() - 6);
    painter.setPen(QPen(ink(Ink::Faint), 1.4));
    painter.setBrush(palette().color(QPalette::AlternateBase));
    painter.drawRoundedRect(body, 4, 4);
    painter.setBrush(ink(Ink::Faint));
    painter.drawRect(QRectF(body.right() + 1, body.center().y() - 4, 3, 8));
    if (!m_level) return;
    const double level = std::clamp(*m_level, 0.0, 1.0);
    QColor fill = ink(level < kAlmostEmpty ? Ink::Error : level < kLow ? Ink::Warning : Ink::Good);
    fill.setAlpha(110);
    painter.setPen(Qt::NoPen);
    painter.setBrush(fill);
    const QRectF inside = body.adjusted(2, 2, -2, -2);
    painter.drawRoundedRect(QRectF(inside.left(), inside.top(), inside.width() * level, inside.height()), 3, 3);
    painter.setPen(palette().color(QPalette::Text));
    painter.setFont(figuresFont(12));
    painter.drawText(body, Qt::AlignCenter, tr("%1 %").arg(QString::number(100 * level, 'f', 1)));
}

} // namespace trundle
