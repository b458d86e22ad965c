#pragma once
#include <QColor>
#include <QLineF>

#include "scene/view.h"

class QPainter;

namespace trundle {

class View;

/// Draws lines of the world over the picture that a view shows, also where they pass the eye or go far out of the picture.
class WorldPen {
public:
    WorldPen(QPainter& painter, const View& view);
    /// On a darker line that is a little wider.
    void line(Vec3 a, Vec3 b, const QColor& colour, double width, Qt::PenStyle style = Qt::SolidLine) const;

private:
    [[nodiscard]] double depthOf(const Vec3& point) const { return -m_axes.col(2).dot(point - m_view.eye); }
    [[nodiscard]] bool clip(QLineF& line) const;

    QPainter& m_painter;
    CameraView m_view;
    Mat3 m_axes;
    std::uint32_t m_width, m_height;
};

} // namespace trundle
