#pragma once
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "model/resolve/footprint.h"

namespace trundle {

/// Footprints of objects near an area, in square cells: which of them a disc meets is found without asking all.
class ObstacleGrid {
public:
    /// `area`: where the centres of the discs are (W, m); `radius`: theirs (m).
    ObstacleGrid(const Eigen::AlignedBox2d& area, double radius);

    void add(const std::vector<GeomSpec>& geoms, const Pose& pose);
    /// Whether a disc with this height range overlaps one of them.
    [[nodiscard]] bool meets(const Eigen::Vector2d& centre, double low, double high) const;

private:
    using Cell = std::pair<long, long>;
    [[nodiscard]] Cell cellOf(const Eigen::Vector2d& point) const;
    void add(Footprint footprint);

    double m_radius, m_side;
    Eigen::AlignedBox2d m_reach; // what outside of it is met by no disc
    std::vector<Footprint> m_all;
    std::vector<std::size_t> m_large; // those over many cells
    std::map<Cell, std::vector<std::size_t>> m_cells;
};

} // namespace trundle
