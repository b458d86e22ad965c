#include "editor/viewport/tools/measure_tool.h"

#include <utility>

#include <QKeyEvent>
#include <QPainter>

#include "editor/viewport/context/label.h"
#include "editor/viewport/context/tool_view.h"
#include "editor/viewport/context/view_settings.h"
#include "editor/widgets/theme.h"
#include "lang/number_text.h"

namespace trundle {
namespace {

QString length(double m) { return QString::fromStdString(steppedNumber(m, 1e-4)) + QStringLiteral(" m"); }

} // namespace

void Measurement::add(const Vec3& point) {
    if (m_points.size() >= 2) m_points.clear();
    m_points.push_back(point);
    m_next.reset();
    Q_EMIT changed();
}

void Measurement::setNext(const std::optional<Vec3>& point) {
    if (point == m_next) return;
    m_next = point;
    Q_EMIT changed();
}

void Measurement::clear() {
    if (m_points.empty() && !m_next) return;
    m_points.clear();
    m_next.reset();
    Q_EMIT changed();
}

MeasureTool::MeasureTool(ToolView& view) : m_view(view), m_measured(view.context().measurement) {
    connect(&m_measured, &Measurement::changed, this, &MeasureTool::showStatus);
    connect(&view.context().settings, &ViewSettings::changed, this, [this] {
        if (isOn()) return;
        m_measured.clear();
        showStatus();
    });
}

bool MeasureTool::isOn() const { return m_view.context().settings.tool() == Tool::Measure; }

bool MeasureTool::press(const Pointer& pointer) {
    if (!isOn() || pointer.button != Qt::LeftButton) return false;
    m_measured.add(m_view.camera().pointUnder(pointer.at));
    return true;
}

bool MeasureTool::hover(const Pointer& pointer) {
    if (!isOn()) return false;
    m_view.hints().setHovered({}, {});
    m_measured.setNext(m_measured.points().size() == 2 ? std::nullopt : std::optional(m_view.camera().pointUnder(pointer.at)));
    return true;
}

bool MeasureTool::key(QKeyEvent& event) {
    if (!isOn() || event.key() != Qt::Key_Escape || m_measured.points().empty()) return false;
    m_measured.clear();
    return true;
}

void MeasureTool::showStatus() {
    const std::vector<Vec3>& points = m_measured.points();
    if (!isOn()) {
        if (std::exchange(m_hintShown, false)) m_view.hints().setHint({}); // clears only this tool's own hint
        return;
    }
    m_hintShown = true;
    if (points.empty()) {
        m_view.hints().setHint(tr("Click the first point"));
    } else if (points.size() == 1) {
        m_view.hints().setHint(tr("Click the second point, in this view or another"));
    } else {
        const Vec3 by = points[1] - points[0];
        m_view.hints().setHint(
            tr("Distance %1 · x %2   y %3   z %4").arg(length(by.norm()), length(by.x()), length(by.y()), length(by.z())));
    }
    m_view.widget().update();
}

void MeasureTool::paint(QPainter& painter) {
    if (!isOn()) return;
    std::vector<Vec3> points = m_measured.points();
    if (m_measured.next()) points.push_back(*m_measured.next());
    std::vector<QPointF> at;
    for (const Vec3& point : points) {
        if (const auto pixel = m_view.shownPixelOf(point)) at.push_back(*pixel);
    }
    const QColor colour(255, 208, 60);
    if (at.size() == 2) {
        painter.setPen(QPen(QColor(10, 12, 16, 120), 4, Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(at[0], at[1]);
        painter.setPen(QPen(colour, 2, Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(at[0], at[1]);
    }
    for (const QPointF& p : at) {
        painter.setPen(QPen(QColor(10, 12, 16, 160), 1));
        painter.setBrush(colour);
        painter.drawEllipse(p, 4, 4);
    }
    if (at.size() == 2) paintLabel(painter, 0.5 * (at[0] + at[1]) + QPointF(0, -18), length((points[1] - points[0]).norm()));
}

} // namespace trundle
