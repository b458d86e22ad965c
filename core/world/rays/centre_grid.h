#pragma once
// Balls around geoms, filed by their centres in a uniform grid over x and y: each is in one cell, and the cells of a row are one stretch of
// memory, so nothing is found twice. Assumes that the balls of a grid are not much larger than its cells.

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include <trundle/geometry.h>

namespace trundle {

struct GeomBall {
    double x, y, z, r;
    std::uint32_t geom, actor;
};

class CentreGrid {
public:
    explicit CentreGrid(double cell) : m_wanted(cell) {}

    /// Balls whose numbers, or their squares, are not finite are left out.
    void build(std::span<const GeomBall> balls);

    /// All whose centre is within the longest radius of a rectangle, and some more: visit(ball).
    template <class Visit> void near(double x0, double x1, double y0, double y1, Visit visit) const {
        if (m_balls.empty()) return;
        const std::size_t a = column(x0 - m_reach), b = column(x1 + m_reach);
        for (std::size_t j = row(y0 - m_reach), last = row(y1 + m_reach); j <= last; ++j) visitRow(j, a, b, visit);
    }
    /// The same for a segment that starts at `from` and goes on by `way`.
    template <class Visit> void along(const Vec3& from, const Vec3& way, Visit visit) const;

private:
    [[nodiscard]] static std::size_t at(double k, std::size_t count) {
        return !(k > 0) ? 0 : k >= static_cast<double>(count) ? count - 1 : static_cast<std::size_t>(k);
    }
    [[nodiscard]] std::size_t column(double x) const { return at((x - m_x0) * m_perCell, m_columns); }
    [[nodiscard]] std::size_t row(double y) const { return at((y - m_y0) * m_perCell, m_rows); }
    template <class Visit> void visitRow(std::size_t row, std::size_t from, std::size_t to, Visit visit) const {
        for (std::uint32_t i = m_begin[row * m_columns + from], end = m_begin[row * m_columns + to + 1]; i < end; ++i)
            visit(m_balls[i]);
    }

    double m_wanted, m_cell = 1, m_perCell = 1, m_x0 = 0, m_y0 = 0, m_reach = 0; ///< m_reach: the longest radius
    std::size_t m_columns = 1, m_rows = 1;
    std::vector<std::uint32_t> m_begin, m_cellOf; ///< by cell, one more at the end; by given ball
    std::vector<GeomBall> m_balls;                ///< in the order of their cells
};

template <class Visit> void CentreGrid::along(const Vec3& from, const Vec3& way, Visit visit) const {
    if (m_balls.empty()) return;
    const double y0 = std::min(from.y(), from.y() + way.y()) - m_reach, y1 = std::max(from.y(), from.y() + way.y()) + m_reach;
    const bool level = std::abs(way.y()) < 1e-12;
    const double inverse = level ? 0 : 1 / way.y();
    for (std::size_t j = row(y0), last = row(y1); j <= last; ++j) {
        // The part of the segment within reach of this row; the first and last row also have what lies beyond them.
        double enter = 0, leave = 1;
        if (!level) {
            const double low = j == 0 ? -1e300 : m_y0 + static_cast<double>(j) * m_cell - m_reach - 1e-9;
            const double high = j + 1 == m_rows ? 1e300 : m_y0 + static_cast<double>(j + 1) * m_cell + m_reach + 1e-9;
            const double a = (low - from.y()) * inverse, b = (high - from.y()) * inverse;
            enter = std::max(0., std::min(a, b));
            leave = std::min(1., std::max(a, b));
            if (enter > leave) continue;
        }
        const double p = from.x() + enter * way.x(), q = from.x() + leave * way.x();
        visitRow(j, column(std::min(p, q) - m_reach - 1e-9), column(std::max(p, q) + m_reach + 1e-9), visit);
    }
}

} // namespace trundle
