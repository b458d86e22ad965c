#include "world/rays/height_blocks.h"

#include <algorithm>

namespace trundle {

HeightBlocks::HeightBlocks(std::shared_ptr<const HeightMap> map, double width, double depth, double height)
    : m_map(std::move(map)) {
    m_cells.samples = m_map->heights.data();
    m_cells.columns = static_cast<int>(m_map->columns) - 1;
    m_cells.rows = static_cast<int>(m_map->rows) - 1;
    m_cells.dx = width / m_cells.columns;
    m_cells.dz = depth / m_cells.rows;
    m_cells.height = height;
    m_cells.levels = 1;
    m_bounds.resize(1); // of the cells: their samples
    while ((std::max(m_cells.columns, m_cells.rows) - 1) >> (m_cells.levels - 1) && m_cells.levels < HeightCells::kMaxLevels)
        addLevel(m_cells.levels++);
}

void HeightBlocks::addLevel(int level) {
    const int columns = HeightCells::blocks(m_cells.columns, level), rows = HeightCells::blocks(m_cells.rows, level);
    std::vector<float> bounds;
    bounds.reserve(2 * static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
    const auto cover = [&](float low, float high) {
        bounds[bounds.size() - 2] = std::min(bounds[bounds.size() - 2], low);
        bounds.back() = std::max(bounds.back(), high);
    };
    const auto samples = [&](int i, int k) {
        return m_cells.samples[static_cast<std::size_t>(k) * m_map->columns + static_cast<std::size_t>(i)];
    };
    const int below = HeightCells::blocks(m_cells.columns, level - 1), belowRows = HeightCells::blocks(m_cells.rows, level - 1);
    for (int k = 0; k < rows; ++k)
        for (int i = 0; i < columns; ++i) {
            bounds.insert(bounds.end(), {1e30f, -1e30f});
            if (level == 1) {
                for (int y = 2 * k; y <= std::min(2 * k + 2, m_cells.rows); ++y)
                    for (int x = 2 * i; x <= std::min(2 * i + 2, m_cells.columns); ++x) cover(samples(x, y), samples(x, y));
                continue;
            }
            for (int y = 2 * k; y < std::min(2 * k + 2, belowRows); ++y)
                for (int x = 2 * i; x < std::min(2 * i + 2, below); ++x) {
                    const float* b =
                        m_cells.bounds[level - 1] +
                        2 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(below) + static_cast<std::size_t>(x));
                    cover(b[0], b[1]);
                }
        }
    m_bounds.push_back(std::move(bounds));
    m_cells.bounds[level] = m_bounds.back().data();
}

Vec3 HeightBlocks::normal(std::size_t part) const {
    const std::size_t cell = part / 2, columns = static_cast<std::size_t>(m_cells.columns), i = cell % columns,
                      k = cell / columns;
    const auto y = [&](std::size_t x, std::size_t z) {
        return m_cells.height * static_cast<double>(m_cells.samples[z * (columns + 1) + x]);
    };
    const double a = y(i, k), b = y(i + 1, k), c = y(i, k + 1), d = y(i + 1, k + 1);
    const double alongX = part % 2 ? d - c : b - a, alongZ = part % 2 ? d - b : c - a;
    return Vec3(-alongX / m_cells.dx, 1, -alongZ / m_cells.dz).normalized();
}

} // namespace trundle
