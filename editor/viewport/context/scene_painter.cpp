#include "editor/viewport/context/scene_painter.h"

#include <QPainter>

#include "editor/viewport/context/tool_view.h"

namespace trundle {
namespace {

constexpr double kLeastDepth = 1e-3; // m
const QColor kLineShade(10, 12, 16, 90), kGuide(90, 220, 130);

} // namespace

ScenePainter::ScenePainter(QPainter& painter, const ToolView& view)
    : m_painter(painter), m_view(view.shownCamera()), m_axes(cameraAxes(m_view)), m_width(std::max(1, view.widget().width())),
      m_height(std::max(1, view.widget().height())) {}

void ScenePainter::line(Vec3 a, Vec3 b, const QColor& colour, double width, Qt::PenStyle style) const {
    const double depthA = depthOf(a), depthB = depthOf(b);
    if (depthA < kLeastDepth && depthB < kLeastDepth) return;
    const Vec3 cut = a + (b - a) * ((kLeastDepth - depthA) / (depthB - depthA));
    if (depthA < kLeastDepth) a = cut;
    if (depthB < kLeastDepth) b = cut;
    const auto from = project(m_view, m_width, m_height, a), to = project(m_view, m_width, m_height, b);
    if (!from || !to) return;
    QLineF shown(from->x, from->y, to->x, to->y);
    if (!clip(shown)) return;
    for (const auto& [ink, wide] : {std::pair(kLineShade, width + 1.6), {colour, width}}) {
        m_painter.setPen(QPen(ink, wide, style, style == Qt::SolidLine ? Qt::RoundCap : Qt::FlatCap));
        m_painter.drawLine(shown);
    }
}

void ScenePainter::polygon(std::span<const Vec3> corners) const {
    QPolygonF shown;
    const auto add = [&](const Vec3& point) {
        if (const auto at = project(m_view, m_width, m_height, point)) shown << QPointF(at->x, at->y);
    };
    for (std::size_t i = 0; i < corners.size(); ++i) { // clipped at the near plane (Sutherland and Hodgman)
        const Vec3 &a = corners[i], &b = corners[(i + 1) % corners.size()];
        const double depthA = depthOf(a) - kLeastDepth, depthB = depthOf(b) - kLeastDepth;
        if (depthA > 0) add(a);
        if (depthA * depthB < 0) add(a + (b - a) * (depthA / (depthA - depthB)) * (1 + 1e-9));
    }
    m_painter.drawPolygon(shown);
}

void ScenePainter::path(std::span<const Vec3> points, const std::vector<bool>& ends) const {
    QList<QLineF> shown;
    std::optional<ImagePoint> last;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto at = depthOf(points[i]) < kLeastDepth ? std::nullopt : project(m_view, m_width, m_height, points[i]);
        if (at && last && i > 0 && !ends[i - 1]) shown << QLineF(last->x, last->y, at->x, at->y);
        last = at;
    }
    m_painter.drawLines(shown);
}

void ScenePainter::guides(std::span<const std::array<Vec3, 2>> lines) const {
    for (const auto& [from, to] : lines) line(from, to, kGuide, 1.5, Qt::DashLine);
}

void ScenePainter::dots(std::span<const Vec3> points, const QColor& colour, double pixels) const {
    QList<QRectF> shown;
    shown.reserve(qsizetype(points.size()));
    for (const Vec3& point : points) {
        if (depthOf(point) < kLeastDepth) continue;
        const auto at = project(m_view, m_width, m_height, point);
        if (at && at->x > 0 && at->y > 0 && at->x < m_width && at->y < m_height)
            shown << QRectF(std::round(at->x - pixels / 2), std::round(at->y - pixels / 2), pixels, pixels);
    }
    m_painter.setPen(Qt::NoPen);
    m_painter.setBrush(colour);
    const bool smooth = m_painter.testRenderHint(QPainter::Antialiasing);
    m_painter.setRenderHint(QPainter::Antialiasing, false); // they are whole pixels, and many
    m_painter.drawRects(shown);
    m_painter.setRenderHint(QPainter::Antialiasing, smooth);
}

/// Clips to the image with a small margin (Liang and Barsky).
bool ScenePainter::clip(QLineF& line) const {
    double from = 0, to = 1;
    const double rim = 8;
    const auto edge = [&](double along, double room) {
        if (along == 0) return room >= 0;
        const double at = room / along;
        if (along < 0) from = std::max(from, at);
        else to = std::min(to, at);
        return from < to;
    };
    if (!edge(-line.dx(), line.x1() + rim) || !edge(line.dx(), m_width + rim - line.x1()) || !edge(-line.dy(), line.y1() + rim) ||
        !edge(line.dy(), m_height + rim - line.y1()))
        return false;
    line = QLineF(line.pointAt(from), line.pointAt(to));
    return true;
}

} // namespace trundle
