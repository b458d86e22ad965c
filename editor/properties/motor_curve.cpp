#include "editor/properties/motor_curve.h"

#include <algorithm>
#include <cmath>

#include <QFontMetrics>
#include <QPainter>

#include "editor/widgets/theme.h"
#include "project/objects/object_location.h"
#include "project/objects/part_values.h"

namespace trundle {
namespace {

constexpr int kCurveHeight = 160, kCurveSamples = 60;

/// Three significant digits.
QString figureOf(double value) { return QString::number(value, 'g', 3); }

class MotorValues {
public:
    MotorValues(const LoadedProject& loaded, const ObjectLocation& place) : m_loaded(loaded), m_place(place) {}
    [[nodiscard]] std::optional<double> find(const char* key) const {
        const auto value = valueAt(m_loaded, m_place, key);
        return value && value->numbers.size() == 1 ? std::optional(value->numbers[0]) : std::nullopt;
    }
    [[nodiscard]] double number(const char* key, double otherwise) const { return find(key).value_or(otherwise); }

private:
    const LoadedProject& m_loaded;
    const ObjectLocation& m_place;
};

/// A RotaryMotor behind its gear.
struct GearedMotor {
    double kt, emf, resistance, gear, limit, efficiency, dry, viscous;

    /// From rest to the speed without load; nothing if its friction holds it.
    [[nodiscard]] std::vector<MotorCharacteristic::Sample> samplesAt(double voltage) const {
        // Without load: kt (V - emf W) / R = dry + viscous W at the rotor.
        const double noLoad = (kt * voltage / resistance - dry) / (kt * emf / resistance + viscous) / gear;
        std::vector<MotorCharacteristic::Sample> samples;
        if (!(noLoad > 0) || !std::isfinite(noLoad)) return samples;
        for (int i = 0; i <= kCurveSamples; ++i) {
            const double speed = noLoad * i / kCurveSamples;
            const double current = std::min((voltage - gear * speed * emf) / resistance, limit);
            const double inner = kt * current - dry - viscous * gear * speed; // N m at the rotor
            samples.push_back({speed, efficiency * gear * inner, current});
        }
        return samples;
    }
};

std::optional<MotorCharacteristic> rotaryMotor(const MotorValues& values) {
    const auto kt = values.find("TorqueConstant"), resistance = values.find("Resistance"), voltage = values.find("MaxVoltage");
    const auto speedConstant = values.find("SpeedConstant"), backEmf = values.find("BackEmfConstant");
    if (!kt || !resistance || !voltage || (!speedConstant && !backEmf)) return std::nullopt;
    const GearedMotor motor{*kt,
                            backEmf ? *backEmf : 1 / *speedConstant,
                            *resistance,
                            values.number("GearRatio", 1),
                            values.number("CurrentLimit", *voltage / *resistance),
                            values.number("Efficiency", 1),
                            values.number("FrictionTorque", 0),
                            values.number("ViscousFriction", 0)};
    MotorCharacteristic made{motor.samplesAt(*voltage), {}, false, true, *voltage};
    if (made.samples.empty()) return std::nullopt;
    for (const double part : {0.25, 0.5, 0.75})
        if (auto samples = motor.samplesAt(part * *voltage); !samples.empty())
            made.parts.push_back({part * *voltage, std::move(samples)});
    return made;
}

std::optional<MotorCharacteristic> servoLine(std::optional<double> effort, std::optional<double> speed, bool isLinear) {
    if (!effort || !speed || !(*effort > 0) || !(*speed > 0)) return std::nullopt;
    return MotorCharacteristic{{{0, *effort, 0}, {*speed, 0, 0}}, {}, isLinear, false, 0};
}

} // namespace

std::optional<MotorCharacteristic> motorCharacteristic(const LoadedProject& loaded, const std::string& path) {
    const auto place = placeOf(loaded, path);
    if (!place || !place->part || !place->part->kind) return std::nullopt;
    const std::string& kind = place->part->kind->name;
    const MotorValues values(loaded, *place);
    if (kind == "RotaryMotor") return rotaryMotor(values);
    if (kind == "Servo") return servoLine(values.find("MaxTorque"), values.find("MaxSpeed"), false);
    if (kind == "LinearMotor") return servoLine(values.find("MaxForce"), values.find("MaxSpeed"), true);
    return std::nullopt;
}

MotorCurve::MotorCurve(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("motorCurve"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

QSize MotorCurve::sizeHint() const { return {200, scaledToFont(kCurveHeight)}; }

void MotorCurve::display(const MotorCharacteristic& motor) {
    m_motor = motor;
    setToolTip(summary());
    setAccessibleName(tr("Motor curve"));
    setAccessibleDescription(summary());
    update();
}

QString MotorCurve::summary() const {
    if (m_motor.samples.empty()) return {};
    const auto &stall = m_motor.samples.front(), &free = m_motor.samples.back();
    const QString effort = figureOf(stall.effort) + (m_motor.isLinear ? tr(" N") : tr(" Nm"));
    const QString speed = figureOf(free.speed) + (m_motor.isLinear ? tr(" m/s") : tr(" rad/s"));
    if (!m_motor.hasCurrent) return tr("Stall %1; no load %2").arg(effort, speed);
    QString text = tr("Stall %1, %2 A; no load %3, %4 A").arg(effort, figureOf(stall.current), speed, figureOf(free.current));
    for (const auto& part : m_motor.parts)
        text += tr("; at %1 V %2 Nm and %3 rad/s")
                    .arg(figureOf(part.voltage), figureOf(part.samples.front().effort), figureOf(part.samples.back().speed));
    return text;
}

void MotorCurve::paintEvent(QPaintEvent*) {
    if (m_motor.samples.size() < 2) return;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QFontMetrics metrics = fontMetrics();
    const int line = metrics.height();
    const QRectF plot = QRectF(rect()).adjusted(10, line + 8, -10, -line - 8);
    const auto& free = m_motor.samples.back();
    double most = 0, mostCurrent = 0;
    for (const auto& s : m_motor.samples) most = std::max(most, s.effort), mostCurrent = std::max(mostCurrent, s.current);
    const auto curveOf = [&](const std::vector<MotorCharacteristic::Sample>& samples, auto valueOf, double top) {
        QPolygonF points;
        for (const auto& s : samples)
            points << QPointF(plot.left() + plot.width() * s.speed / free.speed,
                              plot.bottom() - plot.height() * std::max(0.0, valueOf(s)) / std::max(top, 1e-12));
        return points;
    };
    painter.setPen(QPen(ink(Ink::Line), 1));
    painter.drawLine(plot.bottomLeft(), plot.bottomRight());
    painter.drawLine(plot.bottomLeft(), plot.topLeft());
    painter.setBrush(Qt::NoBrush);
    const auto effortOf = [](const auto& s) { return s.effort; };
    for (const auto& part : m_motor.parts) {
        QColor thin = ink(Ink::Accent);
        thin.setAlphaF(0.55f);
        painter.setPen(QPen(thin, 1));
        const QPolygonF torque = curveOf(part.samples, effortOf, most);
        painter.drawPolyline(torque);
        painter.setPen(ink(Ink::Faint));
        painter.drawText(torque.back() + QPointF(3, -3), tr("%1 V").arg(figureOf(part.voltage)));
    }
    if (m_motor.hasCurrent) {
        painter.setPen(QPen(ink(Ink::Warning), 1.6, Qt::DashLine));
        painter.drawPolyline(curveOf(
            m_motor.samples, [](const auto& s) { return s.current; }, mostCurrent));
    }
    const QPolygonF efforts = curveOf(m_motor.samples, effortOf, most);
    painter.setPen(QPen(ink(Ink::Accent), 2));
    painter.drawPolyline(efforts);
    painter.setBrush(ink(Ink::Accent));
    painter.setPen(Qt::NoPen);
    for (const QPointF& end : {efforts.front(), efforts.back()}) painter.drawEllipse(end, 3.2, 3.2);
    paintFigures(painter);
}

/// Above: torque and current at stall in the colours of their lines. Below: the speeds.
void MotorCurve::paintFigures(QPainter& painter) const {
    const int line = fontMetrics().height();
    const auto &stall = m_motor.samples.front(), &free = m_motor.samples.back();
    const QString effort = figureOf(stall.effort) + (m_motor.isLinear ? tr(" N") : tr(" Nm"));
    painter.setPen(ink(Ink::Accent));
    painter.drawText(QRectF(10, 2, width() - 20, line), Qt::AlignLeft, tr("Stall %1").arg(effort));
    if (m_motor.hasCurrent) {
        painter.setPen(ink(Ink::Warning));
        painter.drawText(QRectF(10, 2, width() - 20, line), Qt::AlignRight, tr("%1 A").arg(figureOf(stall.current)));
    }
    painter.setPen(ink(Ink::Faint));
    const QString speed = figureOf(free.speed) + (m_motor.isLinear ? tr(" m/s") : tr(" rad/s"));
    const QRectF below(10, height() - line - 4, width() - 20, line);
    painter.drawText(below, Qt::AlignRight, tr("No load %1").arg(speed));
    painter.drawText(below, Qt::AlignLeft, QStringLiteral("0"));
}

} // namespace trundle
