#include "editor/sensors/polar_plot.h"

#include <algorithm>
#include <cmath>

#include <QPainter>

#include "editor/widgets/theme.h"

namespace trundle {
namespace {

constexpr int kPlotHeight = 190;

/// 1, 2 or 5 times a power of ten, so that at most three rings fit.
double ringDistance(double reach) {
    const double power = std::pow(10, std::floor(std::log10(reach / 3)));
    for (const double step : {1.0, 2.0, 5.0})
        if (step * power * 3 >= reach * 0.999) return step * power;
    return 10 * power;
}

} // namespace

PolarPlot::PolarPlot(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("polarPlot"));
    setAccessibleName(tr("Distances around the sensor"));
    setToolTip(tr("Distances from above, in the frame of the sensor: x upwards, y to the left"));
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
}

QSize PolarPlot::sizeHint() const { return {200, scaledToFont(kPlotHeight)}; }

void PolarPlot::setFan(std::shared_ptr<const RangeModel> fan) {
    m_fan = std::move(fan);
    m_rings = {};
    m_distances.clear();
    update();
}

void PolarPlot::setDistances(std::span<const double> distances) {
    m_distances.assign(distances.begin(), distances.end());
    update();
}

double PolarPlot::radius() const { return 0.5 * std::min(width(), height()) - 3; }

void PolarPlot::changeEvent(QEvent* event) {
    m_rings = {};
    QWidget::changeEvent(event);
}

QPixmap PolarPlot::drawnRings() const {
    QPixmap rings(size() * devicePixelRatioF());
    rings.setDevicePixelRatio(devicePixelRatioF());
    rings.fill(Qt::transparent);
    QPainter painter(&rings);
    painter.setRenderHint(QPainter::Antialiasing);
    const double scale = radius() / m_fan->maxRange, ring = ringDistance(m_fan->maxRange);
    painter.setPen(Qt::NoPen);
    painter.setBrush(palette().color(QPalette::AlternateBase));
    painter.drawEllipse(middle(), radius(), radius());
    painter.setBrush(Qt::NoBrush);
    painter.setFont(figuresFont(10));
    for (int i = 1; i * ring <= m_fan->maxRange * 1.001; ++i) {
        painter.setPen(QPen(ink(Ink::Line), 1));
        painter.drawEllipse(middle(), i * ring * scale, i * ring * scale);
        painter.setPen(ink(Ink::Faint));
        painter.drawText(middle() + QPointF(3, -i * ring * scale + painter.fontMetrics().ascent() + 1),
                         tr("%1 m").arg(QString::number(i * ring)));
    }
    return rings;
}

/// What the beams crossed, and a dot where each met something. Drawn without smoothing: hundreds of corners would take milliseconds.
void PolarPlot::paintArea(QPainter& painter) const {
    if (m_distances.size() != m_fan->directions.size()) return;
    const double scale = radius() / m_fan->maxRange;
    QColor fill = ink(Ink::Accent);
    fill.setAlpha(std::max(12, 70 / int(m_fan->layers)));
    painter.setPen(Qt::NoPen);
    painter.setBrush(fill);
    QPolygonF area;
    QList<QRectF> echoes;
    for (std::uint32_t layer = 0; layer < m_fan->layers; ++layer) {
        area.clear();
        if (!m_fan->closed) area << middle();
        for (std::uint32_t i = 0; i < m_fan->beams; ++i) {
            const std::size_t beam = std::size_t(layer) * m_fan->beams + i;
            const Vec3 p = std::clamp(m_distances[beam], 0.0, m_fan->maxRange) * scale * m_fan->directions[beam];
            area << middle() + QPointF(-p.y(), -p.x());
            if (m_distances[beam] < m_fan->maxRange)
                echoes << QRectF(std::round(area.back().x()) - 1, std::round(area.back().y()) - 1, 2, 2);
        }
        painter.drawPolygon(area);
    }
    painter.setBrush(ink(Ink::Accent));
    painter.drawRects(echoes);
}

void PolarPlot::paintEvent(QPaintEvent*) {
    if (!m_fan) return;
    if (m_rings.size() != size() * devicePixelRatioF()) m_rings = drawnRings();
    QPainter painter(this);
    painter.drawPixmap(0, 0, m_rings);
    paintArea(painter);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(palette().color(QPalette::Text));
    painter.drawPolygon(QPolygonF{middle() + QPointF(0, -6), middle() + QPointF(-4, 4), middle() + QPointF(4, 4)});
}

} // namespace trundle
