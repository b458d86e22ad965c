// Method of the maze: a random walk that goes back where it is caught (depth-first search), from the lower left cell. Then walls in one line
// are joined: those along x have the posts at their ends, those along y lie between them.

#include "project/wizard/room_plan.h"

#include <algorithm>
#include <array>

#include "base/rng.h"
#include "project/wizard/floor_path.h"

namespace trundle {
namespace {

constexpr int kMostCells = 100; // along a side

Error roomFault(const char* text) { return Error{Code::OutOfRange, text}; }

/// A side as one wall, or as two beside a door in its middle. `length`: of the side; `isAlongX`: the side is.
void addSide(RoomPlan& plan, const std::string& name, double middle, double length, bool isAlongX, double thickness,
             double door) {
    const auto add = [&](const std::string& called, double at, double size) {
        plan.walls.push_back(isAlongX ? RoomWall{called, at, middle, size, thickness}
                                      : RoomWall{called, middle, at, thickness, size});
    };
    if (door <= 0) return add(name, 0, length);
    const double part = (length - door) / 2, at = (length + door) / 4;
    add(name + "1", -at, part);
    add(name + "2", at, part);
}

/// Which walls of the grid there are: `along` is the wall below the cell, `upright` the one left of it, with one more row and column.
struct MazeGrid {
    int rows, columns;
    std::vector<std::uint8_t> along, upright;

    MazeGrid(int r, int c)
        : rows(r), columns(c), along(std::size_t(r + 1) * std::size_t(c), 1), upright(std::size_t(r) * std::size_t(c + 1), 1) {}
    [[nodiscard]] std::uint8_t& alongAt(int row, int column) {
        return along[std::size_t(row) * std::size_t(columns) + std::size_t(column)];
    }
    [[nodiscard]] std::uint8_t& uprightAt(int row, int column) {
        return upright[std::size_t(row) * std::size_t(columns + 1) + std::size_t(column)];
    }
    /// Whether a wall along x ends or passes at this node.
    [[nodiscard]] bool hasAlong(int row, int column) {
        return (column > 0 && alongAt(row, column - 1)) || (column < columns && alongAt(row, column));
    }
};

void carve(MazeGrid& grid, std::uint64_t seed) {
    std::uint64_t draws = 0;
    std::vector<std::uint8_t> isVisited(std::size_t(grid.rows) * std::size_t(grid.columns));
    std::vector<std::array<int, 2>> path{{0, 0}};
    isVisited[0] = 1;
    while (!path.empty()) {
        const auto [row, column] = path.back();
        std::array<std::array<int, 2>, 4> free{};
        std::size_t count = 0;
        for (const auto& [down, right] : {std::array{0, 1}, {1, 0}, {0, -1}, {-1, 0}}) {
            const int r = row + down, c = column + right;
            if (r < 0 || c < 0 || r >= grid.rows || c >= grid.columns) continue;
            if (!isVisited[std::size_t(r) * std::size_t(grid.columns) + std::size_t(c)]) free[count++] = {r, c};
        }
        if (count == 0) {
            path.pop_back();
            continue;
        }
        const double draw = toUnit(randomBits(seed, fnv1a64("maze"), 0, draws++));
        const auto [r, c] = free[std::min(count - 1, static_cast<std::size_t>(draw * double(count)))];
        if (r == row) grid.uprightAt(row, std::max(column, c)) = 0;
        else grid.alongAt(std::max(row, r), column) = 0;
        isVisited[std::size_t(r) * std::size_t(grid.columns) + std::size_t(c)] = 1;
        path.push_back({r, c});
    }
}

void addWalls(RoomPlan& plan, MazeGrid& grid, const MazeOptions& o) {
    const double left = -o.columns * o.cell / 2, bottom = -o.rows * o.cell / 2;
    const auto add = [&](double x, double y, double along, double across) {
        plan.walls.push_back({"wall" + std::to_string(plan.walls.size() + 1), x, y, along, across});
    };
    for (int row = 0; row <= o.rows; ++row)
        for (int from = 0, to = 0; from < o.columns; from = to + 1) {
            for (to = from; to < o.columns && grid.alongAt(row, to);) ++to;
            if (to > from)
                add(left + (from + to) / 2. * o.cell, bottom + row * o.cell, (to - from) * o.cell + o.thickness, o.thickness);
        }
    for (int column = 0; column <= o.columns; ++column)
        for (int from = 0, to = 0; from < o.rows; from = to + 1) {
            for (to = from; to < o.rows && grid.uprightAt(to, column);) ++to;
            if (to == from) continue;
            // Up to the wall across, or to the end of the post without one.
            const double low = from * o.cell + (grid.hasAlong(from, column) ? 1 : -1) * o.thickness / 2;
            const double high = to * o.cell + (grid.hasAlong(to, column) ? -1 : 1) * o.thickness / 2;
            add(left + column * o.cell, bottom + (low + high) / 2, o.thickness, high - low);
        }
}

} // namespace

Result<RoomPlan> roomPlan(const RoomOptions& o) {
    if (!(o.length >= 0.2 && o.length <= 1000 && o.width >= 0.2 && o.width <= 1000))
        return roomFault("The room must be from 0.2 to 1000 m long and wide.");
    if (!(o.height >= 0.01 && o.height <= 100)) return roomFault("The height of the walls must be from 0.01 to 100 m.");
    if (!(o.thickness >= 0.005 && o.thickness <= 10)) return roomFault("The walls must be from 0.005 to 10 m thick.");
    const bool isAlong = o.doorSide == RoomSide::North || o.doorSide == RoomSide::South;
    const double side = isAlong ? o.length : o.width;
    if (o.doorSide != RoomSide::None && !(o.doorWidth >= 0.05 && o.doorWidth < side))
        return roomFault("The door must be at least 0.05 m wide, and narrower than its side.");
    RoomPlan plan{{}, o.length + 2 * o.thickness, o.width + 2 * o.thickness, o.height, 0, 0};
    const double x = (o.length + o.thickness) / 2, y = (o.width + o.thickness) / 2;
    const auto door = [&](RoomSide at) { return o.doorSide == at ? o.doorWidth : 0; };
    addSide(plan, "north", y, plan.length, true, o.thickness, door(RoomSide::North));
    addSide(plan, "south", -y, plan.length, true, o.thickness, door(RoomSide::South));
    addSide(plan, "east", x, o.width, false, o.thickness, door(RoomSide::East));
    addSide(plan, "west", -x, o.width, false, o.thickness, door(RoomSide::West));
    return plan;
}

std::string describe(const RoomOptions& o) {
    constexpr const char* kSides[] = {"", "north", "east", "south", "west"};
    std::string text = "a room, " + tidyNumber(o.length) + " m x " + tidyNumber(o.width) + " m inside";
    if (o.doorSide != RoomSide::None)
        text += ", with a door " + tidyNumber(o.doorWidth) + " m wide in the " + kSides[static_cast<int>(o.doorSide)];
    return text;
}

std::string describe(const MazeOptions& o) {
    return "a maze of " + std::to_string(o.rows) + " rows and " + std::to_string(o.columns) + " columns, of the seed " +
           std::to_string(o.seed);
}

Result<RoomPlan> mazePlan(const MazeOptions& o) {
    if (o.rows < 1 || o.columns < 1 || o.rows > kMostCells || o.columns > kMostCells)
        return roomFault("A maze has from 1 to 100 rows and columns.");
    if (!(o.height >= 0.01 && o.height <= 100)) return roomFault("The height of the walls must be from 0.01 to 100 m.");
    if (!(o.cell >= 0.05 && o.cell <= 100)) return roomFault("A cell must be from 0.05 to 100 m wide.");
    if (!(o.thickness >= 0.002 && o.thickness <= o.cell / 2))
        return roomFault("The walls must be at least 0.002 m thick, and at most half as thick as a cell is wide.");
    MazeGrid grid(o.rows, o.columns);
    carve(grid, o.seed);
    RoomPlan plan{{},       o.columns * o.cell + o.thickness, o.rows * o.cell + o.thickness,
                  o.height, (1 - o.columns) * o.cell / 2,     (1 - o.rows) * o.cell / 2};
    addWalls(plan, grid, o);
    return plan;
}

} // namespace trundle
