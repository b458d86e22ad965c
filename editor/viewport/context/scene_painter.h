#pragma once
#include <array>
#include <span>
#include <vector>

#include <QColor>
#include <QLineF>

#include "scene/queries/camera_view.h"

class QPainter;

namespace trundle {

class ToolView;

/// Draws world-space lines over the rendered image, clipped at the near plane and at the image's edges.
class ScenePainter {
public:
    ScenePainter(QPainter& painter, const ToolView& view);
    /// With the painter's pen and brush.
    void polygon(std::span<const Vec3> corners) const;
    /// From each point to the next, with the painter's pen, except after points that are marked as an end. As many ends as points.
    void path(std::span<const Vec3> points, const std::vector<bool>& ends) const;
    /// A square dot at each point in front of the camera.
    void dots(std::span<const Vec3> points, const QColor& colour, double pixels) const;
    /// Drawn over a slightly wider dark line.
    void line(Vec3 a, Vec3 b, const QColor& colour, double width, Qt::PenStyle style = Qt::SolidLine) const;
    /// Lines that show what something has snapped to.
    void guides(std::span<const std::array<Vec3, 2>> lines) const;

private:
    [[nodiscard]] double depthOf(const Vec3& point) const { return -m_axes.col(2).dot(point - m_view.eye); }
    [[nodiscard]] bool clip(QLineF& line) const;

    QPainter& m_painter;
    CameraView m_view;
    Mat3 m_axes;
    std::uint32_t m_width, m_height;
};

} // namespace trundle
