#include "editor/sensors/reading_row.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <QEvent>
#include <QPainter>

#include "editor/widgets/theme.h"

namespace trundle {
namespace {

constexpr int kTraceHeight = 26, kBarHeight = 6, kRowGap = 3, kUnitGap = 4;
constexpr int kNumberDigits = 9; // "-123.456" and a gap
const QString kNoValue = QStringLiteral("–");

int lineHeight(const QWidget& widget) { return std::max(widget.fontMetrics().height(), QFontMetrics(figuresFont()).height()); }

QColor colourOf(std::size_t number, std::size_t count) {
    if (count == 1) return ink(Ink::Accent);
    constexpr Ink inks[] = {Ink::AxisX, Ink::AxisY, Ink::AxisZ, Ink::Text};
    return ink(inks[std::min<std::size_t>(number, 3)]);
}

} // namespace

ReadingRow::ReadingRow(Reading reading, QWidget* parent)
    : QWidget(parent), m_reading(std::move(reading)), m_trace(2 * m_reading.count),
      m_scale(m_reading.unit, m_reading.type == SignalType::Real ? NumberScale::Kind::Real : NumberScale::Kind::Whole) {
    setObjectName(QStringLiteral("reading.") + QString::fromStdString(m_reading.name));
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    describe();
}

void ReadingRow::describe() {
    const QString name = QString::fromStdString(m_reading.name);
    QStringList lines{name};
    if (!m_reading.help.empty()) lines << QString::fromStdString(m_reading.help);
    lines << tr("Signal %1").arg(QString::fromStdString(m_reading.signal));
    if (m_reading.commanded) lines << tr("A command: set, not measured");
    setToolTip(lines.join(u'\n'));
    setAccessibleName(name);
}

bool ReadingRow::rebind(const Reading& reading) {
    const bool same = reading.name == m_reading.name && reading.signal == m_reading.signal && reading.count == m_reading.count &&
                      reading.unit == m_reading.unit && bool(reading.readTrue) == bool(m_reading.readTrue) &&
                      reading.limits.has_value() == m_reading.limits.has_value();
    if (same) m_reading = reading;
    return same;
}

/// The time of a reading only grows.
bool ReadingRow::hasTrace() const { return m_reading.name != "time" && !m_reading.names; }

void ReadingRow::take(const LiveSnapshot& snapshot, bool measured) {
    std::vector<double> sample(2 * m_reading.count, std::numeric_limits<double>::quiet_NaN());
    const auto half = sample.begin() + std::ptrdiff_t(m_reading.count);
    m_numbers.clear();
    m_trueNumbers.clear();
    if (measured) {
        m_reading.read(snapshot, sample.data());
        m_numbers.assign(sample.begin(), half);
    }
    if (m_reading.readTrue) {
        m_reading.readTrue(snapshot, &*half);
        m_trueNumbers.assign(half, sample.end());
    }
    for (const double number : sample)
        if (!std::isnan(number)) m_scale.note(number);
    if (hasTrace()) m_trace.add(snapshot.time, sample.data());
    update();
}

void ReadingRow::showTrue(bool shown) {
    if (shown == m_showsTrue) return;
    m_showsTrue = shown;
    updateGeometry();
    update();
}

QSize ReadingRow::sizeHint() const {
    const int lines = (m_reading.count > 2 ? 2 : 1) + (hasTrue() ? 1 : 0);
    const int bar = m_reading.limits && m_reading.count == 1 ? kBarHeight + kRowGap : 0;
    return {200, lines * lineHeight(*this) + bar + (hasTrace() ? kTraceHeight + kRowGap : 0) + kRowGap};
}

QString ReadingRow::numberText(double number) const {
    if (m_reading.names) {
        const bool known = number >= 0 && number < double(m_reading.names->size());
        const std::string name = known ? (*m_reading.names)[std::size_t(number)] : std::string();
        return name.empty() ? tr("none") : QString::fromStdString(name);
    }
    if (m_reading.type == SignalType::Boolean) return number != 0 ? tr("true") : tr("false");
    return QString::fromStdString(m_scale.text(number));
}

QString ReadingRow::textOf(const std::vector<double>& numbers) const {
    if (numbers.empty()) return kNoValue;
    QStringList texts;
    for (const double number : numbers) texts << numberText(number);
    return (texts.join(QStringLiteral(", ")) + u' ' + QString::fromStdString(m_scale.unit())).trimmed();
}

void ReadingRow::paintNumbers(QPainter& painter, QRectF line, const std::vector<double>& numbers, const QColor& colour) const {
    const QString unit = QString::fromStdString(m_scale.unit());
    const double unitWidth = m_reading.unit.empty() ? 0 : fontMetrics().horizontalAdvance(QStringLiteral("mN m/s")) + kUnitGap;
    painter.setFont(font());
    painter.setPen(ink(Ink::Faint));
    if (unitWidth > 0)
        painter.drawText(line.adjusted(line.width() - unitWidth + kUnitGap, 0, 0, 0),
                         Qt::AlignLeft | Qt::AlignVCenter | Qt::TextDontClip, unit);
    line.setRight(line.right() - unitWidth);
    painter.setFont(figuresFont(12));
    painter.setPen(colour);
    if (numbers.empty()) return painter.drawText(line, Qt::AlignRight | Qt::AlignVCenter, kNoValue);
    if (m_reading.names) {
        line.setLeft(line.left() + 0.3 * line.width());
        painter.setFont(font());
        return painter.drawText(line, Qt::AlignRight | Qt::AlignVCenter,
                                painter.fontMetrics().elidedText(numberText(numbers[0]), Qt::ElideLeft, int(line.width())));
    }
    const double column = painter.fontMetrics().horizontalAdvance(QString(kNumberDigits, u'0'));
    for (std::size_t i = numbers.size(); i-- > 0;) {
        painter.drawText(line, Qt::AlignRight | Qt::AlignVCenter | Qt::TextDontClip, numberText(numbers[i]));
        line.setRight(line.right() - column);
    }
}

void ReadingRow::paintBar(QPainter& painter, const QRectF& bar) const {
    painter.setPen(Qt::NoPen);
    painter.setBrush(ink(Ink::Line));
    painter.drawRoundedRect(bar, 2, 2);
    const auto [low, high] = *m_reading.limits;
    if (!(high > low)) return;
    const auto x = [&, low = low, high = high](double value) {
        return bar.left() + bar.width() * std::clamp((value - low) / (high - low), 0.0, 1.0);
    };
    if (!m_numbers.empty()) {
        const double zero = x(std::clamp(0.0, low, high)), value = x(m_numbers[0]);
        painter.setBrush(ink(Ink::Accent));
        painter.drawRoundedRect(QRectF(std::min(zero, value), bar.top(), std::abs(value - zero), bar.height()), 2, 2);
    }
    if (!hasTrue() || m_trueNumbers.empty()) return;
    painter.setBrush(ink(Ink::Good));
    painter.drawRect(QRectF(x(m_trueNumbers[0]) - 1, bar.top() - 2, 2, bar.height() + 4));
}

/// Of what the trace shows: the reading's own limits, otherwise from the least to the greatest value.
std::pair<double, double> ReadingRow::traceLimits() const {
    if (m_reading.type == SignalType::Boolean) return {-0.1, 1.1};
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (std::size_t i = 0; i < m_trace.size(); ++i)
        for (std::size_t k = 0; k < (hasTrue() ? 2 : 1) * m_reading.count; ++k) {
            const double value = m_trace.value(i, k);
            if (!std::isfinite(value)) continue;
            low = std::min(low, value);
            high = std::max(high, value);
        }
    if (m_reading.limits) return {std::min(low, m_reading.limits->first), std::max(high, m_reading.limits->second)};
    if (low > high) return {0, 1};
    const double least = std::max(1e-9, 1e-3 * std::max(std::abs(low), std::abs(high))); // noise of rounding is no trace
    const double margin = std::max(0.08 * (high - low), high - low < least ? 0.5 * least : 0);
    return {low - margin, high + margin};
}

void ReadingRow::paintTrace(QPainter& painter, const QRectF& area) const {
    painter.fillRect(area, palette().color(QPalette::AlternateBase));
    if (m_trace.size() < 2 || !(m_trace.seconds() > 0)) return;
    const auto [low, high] = traceLimits();
    const double first = m_trace.time(0), perSecond = area.width() / m_trace.seconds(),
                 perUnit = (area.height() - 2) / (high - low), bottom = area.bottom() - 1;
    if (low < 0 && high > 0) {
        painter.setPen(QPen(ink(Ink::Line), 1));
        const double zero = bottom + low * perUnit;
        painter.drawLine(QPointF(area.left(), zero), QPointF(area.right(), zero));
    }
    QPolygonF points;
    for (std::size_t k = (hasTrue() ? 2 : 1) * m_reading.count; k-- > 0;) { // measured values over true ones
        const bool isTrue = k >= m_reading.count;
        const QColor colour = isTrue && m_reading.count == 1 ? ink(Ink::Good) : colourOf(k % m_reading.count, m_reading.count);
        painter.setPen(QPen(colour, 1, isTrue && m_reading.count > 1 ? Qt::DotLine : Qt::SolidLine));
        points.clear();
        double before = 0;
        for (std::size_t i = 0; i < m_trace.size(); ++i) {
            const double value = m_trace.value(i, k);
            const bool isGap = !std::isfinite(value) || !m_trace.isConnected(i) ||
                               (m_reading.isAngle && std::abs(value - before) > std::numbers::pi);
            if (isGap) {
                painter.drawPolyline(points);
                points.clear();
            }
            if (std::isfinite(value))
                points << QPointF(area.left() + (m_trace.time(i) - first) * perSecond, bottom - (value - low) * perUnit);
            before = value;
        }
        painter.drawPolyline(points);
    }
}

void ReadingRow::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double line = lineHeight(*this), width = this->width();
    painter.setPen(ink(Ink::Faint));
    const bool beside = m_reading.count <= 2;
    const double room = beside ? width - double(m_reading.count) * scaledToFont(64) - scaledToFont(34) : width;
    painter.drawText(QRectF(0, 0, room, line), Qt::AlignLeft | Qt::AlignVCenter,
                     fontMetrics().elidedText(QString::fromStdString(m_reading.name), Qt::ElideMiddle, int(room)));
    double y = beside ? 0 : line;
    paintNumbers(painter, {0, y, width, line}, m_numbers, palette().color(QPalette::Text));
    y += line;
    if (hasTrue()) {
        painter.setFont(font());
        painter.setPen(ink(Ink::Good));
        painter.drawText(QRectF(0, y, width, line), Qt::AlignLeft | Qt::AlignVCenter,
                         m_reading.count > 2 ? QString() : tr("true"));
        paintNumbers(painter, {0, y, width, line}, m_trueNumbers, ink(Ink::Good));
        y += line;
    }
    if (m_reading.limits && m_reading.count == 1) {
        paintBar(painter, QRectF(0, y + 1, width, kBarHeight));
        y += kBarHeight + kRowGap;
    }
    if (hasTrace()) paintTrace(painter, QRectF(0, y + 1, width, kTraceHeight));
}

void ReadingRow::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange) updateGeometry();
}

} // namespace trundle
