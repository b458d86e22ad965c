#pragma once
// A map of square cells, each free, occupied or unknown, by what the beams of a lidar have passed and hit.

#include <string>
#include <vector>

namespace lidar_map {

struct Cell {
    int x = 0, y = 0;
    [[nodiscard]] bool operator==(const Cell&) const = default;
};

enum class Occupancy { Unknown, Free, Occupied };

/// Square, with the origin of its frame in its middle. A cell counts the beams that have passed it and those that have ended in it, each
/// by its weight; it is occupied if it has stopped at least half of them. This is the counting model of Hähnel, Burgard, Fox and Thrun (An
/// efficient FastSLAM algorithm for generating maps of large-scale cyclic environments, 2003).
class OccupancyGrid {
public:
    /// `side`: of the map, `cellSize`: of a cell; m.
    OccupancyGrid(double side, double cellSize);

    /// A beam from (x, y) with this bearing (m, rad), which ends after `range` m; `isHit`: at something. `deviation`: of the range, m.
    void addBeam(double x, double y, double bearing, double range, bool isHit, double deviation);

    [[nodiscard]] int count() const { return m_count; } ///< cells on a side
    [[nodiscard]] double cellSize() const { return m_cellSize; }
    [[nodiscard]] bool contains(Cell c) const { return c.x >= 0 && c.y >= 0 && c.x < m_count && c.y < m_count; }
    [[nodiscard]] Cell cellAt(double x, double y) const;
    [[nodiscard]] double middle(int index) const { return (index + 0.5) * m_cellSize - m_half; } ///< m, of x or y
    [[nodiscard]] Occupancy at(Cell c) const;
    /// m^2 that are free or occupied.
    [[nodiscard]] double knownArea() const;

    /// A binary PGM picture with y upwards: 254 free, 205 unknown, 0 occupied; and what map_server of ROS reads with it.
    [[nodiscard]] std::string picture() const;
    [[nodiscard]] std::string pictureDescription(const std::string& pictureName) const;

private:
    struct Count {
        double passed = 0, stopped = 0;
    };
    [[nodiscard]] std::size_t index(Cell c) const;

    double m_cellSize, m_half;
    int m_count;
    std::vector<Count> m_cells;
};

} // namespace lidar_map
