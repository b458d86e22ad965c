#include "model/resolve/obstacle_grid.h"

#include <algorithm>
#include <cmath>

namespace trundle {
namespace {

constexpr double kLeastSide = 0.05; // m
constexpr long kMostCells = 64;     // of one footprint

} // namespace

ObstacleGrid::ObstacleGrid(const Eigen::AlignedBox2d& area, double radius)
    : m_radius(radius), m_side(std::max(2 * radius, kLeastSide)),
      m_reach(area.min().array() - radius, area.max().array() + radius) {}

ObstacleGrid::Cell ObstacleGrid::cellOf(const Eigen::Vector2d& point) const {
    const auto index = [&](double v) { return static_cast<long>(std::floor(std::clamp(v / m_side, -1e15, 1e15))); };
    return {index(point.x()), index(point.y())};
}

void ObstacleGrid::add(const std::vector<GeomSpec>& geoms, const Pose& pose) {
    for (const GeomSpec& geom : geoms)
        for (Footprint& footprint : footprintsOf(geom, pose)) add(std::move(footprint));
}

void ObstacleGrid::add(Footprint footprint) {
    Eigen::AlignedBox2d box;
    for (const Eigen::Vector2d& corner : footprint.corners) box.extend(corner);
    box.min().array() -= footprint.grown;
    box.max().array() += footprint.grown;
    if (!box.intersects(m_reach)) return;
    const std::size_t index = m_all.size();
    m_all.push_back(std::move(footprint));
    const Eigen::AlignedBox2d near = box.intersection(m_reach);
    const auto [left, bottom] = cellOf(near.min());
    const auto [right, top] = cellOf(near.max());
    if ((right - left + 1) > kMostCells / (top - bottom + 1)) return m_large.push_back(index);
    for (long x = left; x <= right; ++x)
        for (long y = bottom; y <= top; ++y) m_cells[{x, y}].push_back(index);
}

bool ObstacleGrid::meets(const Eigen::Vector2d& centre, double low, double high) const {
    const auto isMet = [&](std::size_t index) { return m_all[index].meets(centre, m_radius, low, high); };
    if (std::ranges::any_of(m_large, isMet)) return true;
    const auto [left, bottom] = cellOf(centre.array() - m_radius);
    const auto [right, top] = cellOf(centre.array() + m_radius);
    for (long x = left; x <= right; ++x)
        for (long y = bottom; y <= top; ++y)
            if (const auto found = m_cells.find({x, y}); found != m_cells.end() && std::ranges::any_of(found->second, isMet))
                return true;
    return false;
}

} // namespace trundle
