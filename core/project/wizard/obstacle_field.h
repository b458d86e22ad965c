#pragma once
// Obstacles at random places, the same for the same seed on any machine.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "base/result.h"

namespace trundle {

struct ObstacleField {
    double length = 6, width = 4; ///< m, along x and y, around the origin
    int count = 12;
    double least = 0.15, most = 0.5; ///< m, across an obstacle
    double apart = 0.35;             ///< m, least between two of them, and around what stays free
    std::uint64_t seed = 1;
    std::vector<std::array<double, 3>> free{{0, 0, 0.2}}; ///< circles without obstacles: x, y, radius in m
    std::vector<std::array<double, 4>> occupied;          ///< rectangles of what is there: least x and y, largest x and y, in m
};

/// A box, or a cylinder with `across` as its diameter, on the floor.
struct FieldObstacle {
    std::string name; ///< crate1, drum2
    bool isRound = false;
    double x = 0, y = 0;                   ///< m
    double across = 0, deep = 0, high = 0; ///< m
    double heading = 0;                    ///< degrees
};

/// Fails if a number is out of range or that many have no room.
[[nodiscard]] Result<std::vector<FieldObstacle>> obstacleField(const ObstacleField& field);

/// Its geom as a line of text.
[[nodiscard]] std::string obstacleLine(const FieldObstacle& obstacle);

} // namespace trundle
