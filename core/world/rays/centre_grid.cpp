#include "world/rays/centre_grid.h"

#include <algorithm>

namespace trundle {

namespace {

bool isPlace(const GeomBall& b) { return std::isfinite(b.x * b.x + b.y * b.y + b.z * b.z + b.r); }

} // namespace

void CentreGrid::build(std::span<const GeomBall> balls) {
    double x1 = -1e300, y1 = -1e300;
    m_x0 = m_y0 = 1e300;
    m_reach = 0;
    std::size_t count = 0;
    for (const GeomBall& b : balls) {
        if (!isPlace(b)) continue;
        ++count;
        m_x0 = std::min(m_x0, b.x);
        m_y0 = std::min(m_y0, b.y);
        x1 = std::max(x1, b.x);
        y1 = std::max(y1, b.y);
        m_reach = std::max(m_reach, b.r);
    }
    if (count == 0) {
        m_balls.clear();
        return;
    }
    m_cell = m_wanted; // larger where the world is large and empty
    while ((1 + (x1 - m_x0) / m_cell) * (1 + (y1 - m_y0) / m_cell) > 4. * static_cast<double>(count) + 256) m_cell *= 2;
    m_perCell = 1 / m_cell;
    m_columns = static_cast<std::size_t>((x1 - m_x0) / m_cell) + 1;
    m_rows = static_cast<std::size_t>((y1 - m_y0) / m_cell) + 1;
    m_begin.assign(m_columns * m_rows + 1, 0);
    m_cellOf.resize(balls.size());
    for (std::size_t i = 0; i < balls.size(); ++i) {
        const GeomBall& b = balls[i];
        const bool finite = isPlace(b);
        m_cellOf[i] = finite ? static_cast<std::uint32_t>(row(b.y) * m_columns + column(b.x)) : 0xffffffffu;
        if (finite) ++m_begin[m_cellOf[i]];
    }
    for (std::size_t k = 1; k < m_begin.size(); ++k) m_begin[k] += m_begin[k - 1];
    m_balls.resize(count);
    for (std::size_t i = balls.size(); i-- > 0;)
        if (m_cellOf[i] != 0xffffffffu) m_balls[--m_begin[m_cellOf[i]]] = balls[i];
}

} // namespace trundle
