#include "frontier_planner.h"

#include <algorithm>
#include <array>
#include <deque>

namespace lidar_map {

namespace {

constexpr std::array<Cell, 8> kNeighbours{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}}};

Cell beside(Cell c, Cell way) { return {c.x + way.x, c.y + way.y}; }

} // namespace

std::size_t FrontierPlanner::index(Cell c) const {
    return static_cast<std::size_t>(c.y) * static_cast<std::size_t>(m_map.count()) + static_cast<std::size_t>(c.x);
}

/// Breadth first from all occupied cells, up to `most` steps from them.
void FrontierPlanner::measureClearances(int most) {
    m_steps.assign(static_cast<std::size_t>(m_map.count()) * static_cast<std::size_t>(m_map.count()), 1 << 20);
    std::deque<Cell> open;
    for (int y = 0; y < m_map.count(); ++y)
        for (int x = 0; x < m_map.count(); ++x)
            if (m_map.at({x, y}) == Occupancy::Occupied) {
                m_steps[index({x, y})] = 0;
                open.push_back({x, y});
            }
    for (; !open.empty() && m_steps[index(open.front())] < most; open.pop_front())
        for (const Cell way : kNeighbours) {
            const Cell next = beside(open.front(), way);
            if (!m_map.contains(next) || m_steps[index(next)] <= m_steps[index(open.front())] + 1) continue;
            m_steps[index(next)] = m_steps[index(open.front())] + 1;
            open.push_back(next);
        }
}

bool FrontierPlanner::isFrontier(Cell c) const {
    return std::any_of(kNeighbours.begin(), kNeighbours.end(), [&](Cell way) {
        return m_map.contains(beside(c, way)) && m_map.at(beside(c, way)) == Occupancy::Unknown;
    });
}

std::optional<std::vector<Cell>> FrontierPlanner::path(Cell start) {
    if (!m_map.contains(start)) return {};
    const int needed = static_cast<int>(m_clearance / m_map.cellSize() + 0.5);
    measureClearances(needed);
    std::vector<int> from(m_steps.size(), -1); // by which way
    std::deque<Cell> open{start};
    from[index(start)] = 0;
    for (; !open.empty(); open.pop_front()) {
        Cell here = open.front();
        if (m_steps[index(here)] >= needed && !(here == start) && isFrontier(here)) {
            std::vector<Cell> cells;
            while (!(here == start)) {
                cells.push_back(here);
                const Cell way = kNeighbours[static_cast<std::size_t>(from[index(here)])];
                here = {here.x - way.x, here.y - way.y};
            }
            std::reverse(cells.begin(), cells.end());
            return cells;
        }
        for (std::size_t i = 0; i < kNeighbours.size(); ++i) {
            const Cell next = beside(here, kNeighbours[i]);
            if (!m_map.contains(next) || from[index(next)] >= 0 || m_map.at(next) != Occupancy::Free) continue;
            if (m_steps[index(next)] < std::min(needed, m_steps[index(here)])) continue;
            from[index(next)] = static_cast<int>(i);
            open.push_back(next);
        }
    }
    return {};
}

} // namespace lidar_map
