#pragma once
// Broad phase: finds boxes that may touch, with uniform grids over x and y. Results are sorted and do not depend on the order
// inside the grids.

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace trundle {

/// Axis-aligned bounding box, bounds included.
struct Box3 {
    double lo[3] = {0, 0, 0};
    double hi[3] = {0, 0, 0};

    [[nodiscard]] bool touches(const Box3& o) const {
        return lo[0] <= o.hi[0] && o.lo[0] <= hi[0] && lo[1] <= o.hi[1] && o.lo[1] <= hi[1] && lo[2] <= o.hi[2] &&
               o.lo[2] <= hi[2];
    }
    void cover(const Box3& o) {
        for (int k = 0; k < 3; ++k) {
            if (o.lo[k] < lo[k]) lo[k] = o.lo[k];
            if (o.hi[k] > hi[k]) hi[k] = o.hi[k];
        }
    }
};

/// Grid of boxes that never move. Boxes that cover much of the grid are kept in a separate list.
class StaticGrid {
public:
    void build(std::vector<Box3> boxes);
    /// Indices of the boxes that touch `box`, ascending. Several threads may ask at once.
    void query(const Box3& box, std::vector<std::uint32_t>& out) const;

private:
    std::vector<Box3> m_boxes;
    std::vector<std::uint32_t> m_large, m_begin, m_items;
    int m_columns = 0, m_rows = 0;
    double m_x0 = 0, m_y0 = 0, m_cell = 1;

    [[nodiscard]] int column(double x) const;
    [[nodiscard]] int row(double y) const;
};

using IndexPair = std::pair<std::uint32_t, std::uint32_t>;

/// Grid of moving boxes, rebuilt for every query. Linear in their number if most are of similar size.
class PairGrid {
public:
    /// All pairs (low, high) of touching boxes, sorted.
    void pairs(std::span<const Box3> boxes, std::vector<IndexPair>& out);

    // The same box by box: file() first, then partnersOf() for each, also by several threads at once.
    void file(std::span<const Box3> boxes);
    /// The boxes after box i that touch it, ascending.
    void partnersOf(std::uint32_t i, std::span<const Box3> boxes, std::vector<std::uint32_t>& out) const;

private:
    static constexpr std::uint32_t kLarge = 0xffffffffu; ///< in place of a bucket

    double m_cell = 0;
    std::size_t m_count = 0;
    std::vector<std::uint32_t> m_begin, m_items, m_large;
    std::vector<std::pair<std::int64_t, std::int64_t>> m_at;
    std::vector<std::uint32_t> m_bucket;

    void chooseCell(std::span<const Box3> boxes);
    void sortIntoBuckets(std::span<const Box3> boxes);
    void pairsOf(std::uint32_t i, std::span<const Box3> boxes, std::vector<IndexPair>& out) const;
};

} // namespace trundle
