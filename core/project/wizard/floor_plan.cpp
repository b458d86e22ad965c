// Method: rows of wall cells that are equally long and below each other are one box; the same by columns, and by boxes that grow to
// the right and down, the fewest are taken. A picture that needs too many boxes is halved until it does not.

#include "project/wizard/floor_plan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace trundle {
namespace {

/// Which cells are wall.
struct Mask {
    std::uint32_t columns = 0, rows = 0;
    std::vector<std::uint8_t> cells;

    [[nodiscard]] bool at(std::uint32_t x, std::uint32_t y) const { return cells[std::size_t(y) * columns + x] != 0; }
    void set(std::uint32_t x, std::uint32_t y, bool wall) { cells[std::size_t(y) * columns + x] = wall; }
};

Mask wallsOf(const HeightMap& picture, const FloorPlanOptions& options) {
    Mask mask{picture.columns, picture.rows, std::vector<std::uint8_t>(picture.heights.size())};
    std::ranges::transform(picture.heights, mask.cells.begin(), [&](float value) {
        return static_cast<std::uint8_t>((double(value) < options.threshold) != options.isInverted);
    });
    return mask;
}

/// A cell of four is wall if two of them are: thin walls stay closed. At the edges it has fewer.
Mask halved(const Mask& mask) {
    Mask half{(mask.columns + 1) / 2, (mask.rows + 1) / 2, {}};
    half.cells.resize(std::size_t(half.columns) * half.rows);
    for (std::uint32_t y = 0; y < half.rows; ++y)
        for (std::uint32_t x = 0; x < half.columns; ++x) {
            int walls = 0, cells = 0;
            for (std::uint32_t v = 2 * y; v < std::min(2 * y + 2, mask.rows); ++v)
                for (std::uint32_t u = 2 * x; u < std::min(2 * x + 2, mask.columns); ++u) ++cells, walls += mask.at(u, v);
            half.set(x, y, 2 * walls >= cells);
        }
    return half;
}

Mask turned(const Mask& mask) {
    Mask other{mask.rows, mask.columns, std::vector<std::uint8_t>(mask.cells.size())};
    for (std::uint32_t y = 0; y < mask.rows; ++y)
        for (std::uint32_t x = 0; x < mask.columns; ++x) other.set(y, x, mask.at(x, y));
    return other;
}

/// Runs of a row that begin and end as one of the row above continue its box.
std::vector<PlanBox> boxesByRows(const Mask& mask) {
    std::vector<PlanBox> boxes;
    constexpr auto kNone = std::numeric_limits<std::size_t>::max();
    std::vector<std::size_t> above(mask.columns, kNone), now(mask.columns, kNone); // box by the column in which its run begins
    for (std::uint32_t y = 0; y < mask.rows; ++y) {
        std::ranges::fill(now, kNone);
        for (std::uint32_t x = 0; x < mask.columns;) {
            if (!mask.at(x, y)) {
                ++x;
                continue;
            }
            const std::uint32_t from = x;
            while (x < mask.columns && mask.at(x, y)) ++x;
            std::size_t box = above[from];
            if (box == kNone || boxes[box].width != x - from) {
                box = boxes.size();
                boxes.push_back({from, y, x - from, 0});
            }
            ++boxes[box].height;
            now[from] = box;
        }
        std::swap(above, now);
    }
    return boxes;
}

/// Each box grows from its upper left cell, to the right first or down first, whichever is larger.
std::vector<PlanBox> boxesByGrowth(Mask mask) {
    std::vector<PlanBox> boxes;
    const auto isWall = [&](const PlanBox& b) {
        for (std::uint32_t y = b.y; y < b.y + b.height; ++y)
            for (std::uint32_t x = b.x; x < b.x + b.width; ++x)
                if (!mask.at(x, y)) return false;
        return true;
    };
    const auto growRight = [&](PlanBox& b) {
        while (b.x + b.width < mask.columns && isWall({b.x + b.width, b.y, 1, b.height})) ++b.width;
    };
    const auto growDown = [&](PlanBox& b) {
        while (b.y + b.height < mask.rows && isWall({b.x, b.y + b.height, b.width, 1})) ++b.height;
    };
    for (std::uint32_t y = 0; y < mask.rows; ++y)
        for (std::uint32_t x = 0; x < mask.columns; ++x) {
            if (!mask.at(x, y)) continue;
            PlanBox right{x, y, 1, 1}, down = right;
            growRight(right), growDown(right);
            growDown(down), growRight(down);
            const bool isRight = std::size_t(right.width) * right.height >= std::size_t(down.width) * down.height;
            boxes.push_back(isRight ? right : down);
            const PlanBox& b = boxes.back();
            for (std::uint32_t v = b.y; v < b.y + b.height; ++v)
                for (std::uint32_t u = b.x; u < b.x + b.width; ++u) mask.set(u, v, false);
        }
    return boxes;
}

std::vector<PlanBox> fewestBoxes(const Mask& mask) {
    std::vector<PlanBox> byColumns = boxesByRows(turned(mask));
    for (PlanBox& b : byColumns) b = {b.y, b.x, b.height, b.width};
    std::vector<PlanBox> best = boxesByGrowth(mask);
    for (std::vector<PlanBox>* other : {&byColumns})
        if (other->size() < best.size()) best = std::move(*other);
    if (std::vector<PlanBox> byRows = boxesByRows(mask); byRows.size() < best.size()) best = std::move(byRows);
    return best;
}

/// Distances in cells to the nearest wall or edge, diagonal steps counting as one (chessboard distance), in two passes.
std::vector<std::uint32_t> distances(const Mask& mask) {
    std::vector<std::uint32_t> far(mask.cells.size());
    const auto at = [&](std::int64_t x, std::int64_t y) -> std::uint32_t {
        if (x < 0 || y < 0 || x >= mask.columns || y >= mask.rows) return 0;
        return far[std::size_t(y) * mask.columns + std::size_t(x)];
    };
    for (const bool isBack : {false, true})
        for (std::uint32_t i = 0; i < mask.rows; ++i)
            for (std::uint32_t k = 0; k < mask.columns; ++k) {
                const std::int64_t y = isBack ? mask.rows - 1 - i : i, x = isBack ? mask.columns - 1 - k : k, s = isBack ? 1 : -1;
                std::uint32_t& value = far[std::size_t(y) * mask.columns + std::size_t(x)];
                if (mask.at(std::uint32_t(x), std::uint32_t(y))) continue;
                const std::uint32_t least = 1 + std::min({at(x + s, y), at(x, y + s), at(x + s, y + s), at(x - s, y + s)});
                value = isBack ? std::min(value, least) : least;
            }
    return far;
}

void findFreest(const Mask& mask, FloorPlan& plan) {
    const std::vector<std::uint32_t> far = distances(mask);
    const auto best = std::size_t(std::ranges::max_element(far) - far.begin());
    plan.room = (double(far[best]) - 0.5) * plan.cell;
    plan.freest = {(double(best % mask.columns) + 0.5 - 0.5 * mask.columns) * plan.cell,
                   (0.5 * mask.rows - double(best / mask.columns) - 0.5) * plan.cell};
}

Error outOfRange(const char* text) { return Error{Code::OutOfRange, text}; }

} // namespace

Result<FloorPlan> floorPlanFrom(const HeightMap& picture, const FloorPlanOptions& options) {
    if (!(options.threshold > 0 && options.threshold < 1)) return outOfRange("The threshold must be between 0 and 1.");
    if (!(options.width >= 0.1 && options.width <= 10000))
        return outOfRange("The width of the plan must be from 0.1 to 10000 m.");
    if (options.mostBoxes == 0 || picture.heights.empty()) return outOfRange("The picture is empty.");
    Mask mask = wallsOf(picture, options);
    const auto walls = std::size_t(std::ranges::count(mask.cells, 1));
    if (walls == 0) return outOfRange("Nothing in the picture is wall: raise the threshold, or take the light parts as walls.");
    if (walls == mask.cells.size())
        return outOfRange("All of the picture is wall: lower the threshold, or take the light parts as walls.");
    FloorPlan plan;
    plan.walls = fewestBoxes(mask);
    while (plan.walls.size() > options.mostBoxes) {
        mask = halved(mask);
        plan.step *= 2;
        plan.walls = fewestBoxes(mask);
    }
    plan.columns = mask.columns;
    plan.rows = mask.rows;
    plan.cell = options.width / picture.columns * plan.step;
    findFreest(mask, plan);
    return plan;
}

} // namespace trundle
