#include "occupancy_grid.h"

#include <cmath>
#include <sstream>

namespace lidar_map {

namespace {

constexpr double kLeast = 1; // weight of beams that make a cell known

} // namespace

OccupancyGrid::OccupancyGrid(double side, double cellSize)
    : m_cellSize(cellSize), m_count(2 * static_cast<int>(std::ceil(side / cellSize / 2))) {
    m_half = m_count * cellSize / 2;
    m_cells.resize(static_cast<std::size_t>(m_count) * static_cast<std::size_t>(m_count));
}

std::size_t OccupancyGrid::index(Cell c) const {
    return static_cast<std::size_t>(c.y) * static_cast<std::size_t>(m_count) + static_cast<std::size_t>(c.x);
}

Cell OccupancyGrid::cellAt(double x, double y) const {
    return {static_cast<int>(std::floor((x + m_half) / m_cellSize)), static_cast<int>(std::floor((y + m_half) / m_cellSize))};
}

Occupancy OccupancyGrid::at(Cell c) const {
    if (!contains(c)) return Occupancy::Unknown;
    const Count& n = m_cells[index(c)];
    if (n.passed + n.stopped < kLeast) return Occupancy::Unknown;
    return n.stopped >= n.passed ? Occupancy::Occupied : Occupancy::Free;
}

/// In steps of a quarter of a cell, each cell once. Exact beams count more than others, by the square of their deviation.
void OccupancyGrid::addBeam(double x, double y, double bearing, double range, bool isHit, double deviation) {
    const double cells = 2 * deviation / m_cellSize, weight = 1 / (1 + cells * cells);
    const double c = std::cos(bearing), s = std::sin(bearing), step = m_cellSize / 4;
    const Cell end = cellAt(x + range * c, y + range * s);
    Cell last{-1, -1};
    for (double way = 0; way < range; way += step) {
        const Cell cell = cellAt(x + way * c, y + way * s);
        if (cell == last || (isHit && cell == end)) continue;
        last = cell;
        if (contains(cell)) m_cells[index(cell)].passed += weight;
    }
    if (isHit && contains(end)) m_cells[index(end)].stopped += weight;
}

double OccupancyGrid::knownArea() const {
    std::size_t known = 0;
    for (const Count& n : m_cells) known += n.passed + n.stopped >= kLeast ? 1 : 0;
    return static_cast<double>(known) * m_cellSize * m_cellSize;
}

std::string OccupancyGrid::picture() const {
    std::string bytes = "P5\n" + std::to_string(m_count) + " " + std::to_string(m_count) + "\n255\n";
    for (int y = m_count - 1; y >= 0; --y)
        for (int x = 0; x < m_count; ++x) {
            const Occupancy now = at({x, y});
            bytes += static_cast<char>(now == Occupancy::Free ? 254 : now == Occupancy::Occupied ? 0 : 205);
        }
    return bytes;
}

std::string OccupancyGrid::pictureDescription(const std::string& pictureName) const {
    std::ostringstream text;
    text << "image: " << pictureName << "\nresolution: " << m_cellSize << "\norigin: [" << -m_half << ", " << -m_half
         << ", 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";
    return text.str();
}

} // namespace lidar_map
