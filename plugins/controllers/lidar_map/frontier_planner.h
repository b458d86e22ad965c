#pragma once
// Where to drive to see what is not known yet.

#include <optional>

#include "occupancy_grid.h"

namespace lidar_map {

/// Plans in a map to the nearest frontier: a free cell beside an unknown one (Yamauchi: A frontier-based approach for autonomous
/// exploration, 1997). All on free cells that are at least `clearance` m from what is occupied; where the robot is nearer, its way out does
/// not get nearer still.
class FrontierPlanner {
public:
    FrontierPlanner(const OccupancyGrid& map, double clearance) : m_map(map), m_clearance(clearance) {}

    /// The cells from `start` to the nearest frontier, without `start`; none: there is no frontier that it could reach.
    [[nodiscard]] std::optional<std::vector<Cell>> path(Cell start);

private:
    void measureClearances(int most);
    [[nodiscard]] bool isFrontier(Cell c) const;
    [[nodiscard]] std::size_t index(Cell c) const;

    const OccupancyGrid& m_map;
    double m_clearance;
    std::vector<int> m_steps; ///< of each cell to the nearest occupied one, as far as they matter
};

} // namespace lidar_map
