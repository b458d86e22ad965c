#include "world/broad_phase.h"

#include <algorithm>
#include <cmath>

namespace trundle {

namespace {

constexpr int kMaxCells = 256;   // per side of the static grid
constexpr int kLargeCovers = 64; // cells; boxes that cover more are always tested
constexpr double kSmallestCell = 1e-3;

double widest(const Box3& b) { return std::max(b.hi[0] - b.lo[0], b.hi[1] - b.lo[1]); }

/// Cells side by side in x have buckets side by side.
std::size_t hashCell(std::int64_t x, std::int64_t y) {
    return static_cast<std::size_t>(static_cast<std::uint64_t>(x) + static_cast<std::uint64_t>(y) * 0x9e3779b97f4a7c15ull);
}

} // namespace

void StaticGrid::build(std::vector<Box3> boxes) {
    m_boxes = std::move(boxes);
    m_large.clear();
    m_begin.clear();
    m_items.clear();
    m_columns = m_rows = 0;
    if (m_boxes.empty()) return;

    std::vector<double> widths;
    Box3 all = m_boxes[0];
    for (const Box3& b : m_boxes) {
        widths.push_back(widest(b));
        all.cover(b);
    }
    std::nth_element(widths.begin(), widths.begin() + static_cast<std::ptrdiff_t>(widths.size() / 2), widths.end());
    m_cell = std::max({widths[widths.size() / 2], widest(all) / kMaxCells, kSmallestCell});
    m_x0 = all.lo[0];
    m_y0 = all.lo[1];
    m_columns = std::clamp(static_cast<int>((all.hi[0] - m_x0) / m_cell) + 1, 1, kMaxCells);
    m_rows = std::clamp(static_cast<int>((all.hi[1] - m_y0) / m_cell) + 1, 1, kMaxCells);

    std::vector<std::vector<std::uint32_t>> cells(static_cast<std::size_t>(m_columns) * static_cast<std::size_t>(m_rows));
    for (std::uint32_t i = 0; i < m_boxes.size(); ++i) {
        const Box3& b = m_boxes[i];
        const int x0 = column(b.lo[0]), x1 = column(b.hi[0]), y0 = row(b.lo[1]), y1 = row(b.hi[1]);
        if ((x1 - x0 + 1) * (y1 - y0 + 1) > kLargeCovers) {
            m_large.push_back(i);
            continue;
        }
        for (int y = y0; y <= y1; ++y)
            for (int x = x0; x <= x1; ++x) cells[static_cast<std::size_t>(y * m_columns + x)].push_back(i);
    }
    m_begin.push_back(0);
    for (const auto& cell : cells) {
        m_items.insert(m_items.end(), cell.begin(), cell.end());
        m_begin.push_back(static_cast<std::uint32_t>(m_items.size()));
    }
}

int StaticGrid::column(double x) const { return static_cast<int>(std::clamp((x - m_x0) / m_cell, 0.0, m_columns - 1.0)); }
int StaticGrid::row(double y) const { return static_cast<int>(std::clamp((y - m_y0) / m_cell, 0.0, m_rows - 1.0)); }

void StaticGrid::query(const Box3& box, std::vector<std::uint32_t>& out) const {
    out.clear();
    if (m_boxes.empty()) return;
    const auto take = [&](std::uint32_t i) {
        if (m_boxes[i].touches(box)) out.push_back(i);
    };
    for (const std::uint32_t i : m_large) take(i);
    const int x0 = column(box.lo[0]), x1 = column(box.hi[0]), y0 = row(box.lo[1]), y1 = row(box.hi[1]);
    for (int y = y0; y <= y1; ++y)
        for (int x = x0; x <= x1; ++x) {
            const auto cell = static_cast<std::size_t>(y * m_columns + x);
            for (std::uint32_t k = m_begin[cell]; k < m_begin[cell + 1]; ++k) take(m_items[k]);
        }
    if (out.size() < 2) return;
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end()); // one box may be in several cells
}

void PairGrid::chooseCell(std::span<const Box3> boxes) {
    // The cell size fits 90 % of the boxes in any orientation. Chosen once; it affects only the speed.
    std::vector<double> widths;
    for (const Box3& b : boxes) widths.push_back(std::hypot(b.hi[0] - b.lo[0], b.hi[1] - b.lo[1], b.hi[2] - b.lo[2]));
    const std::size_t at = widths.size() * 9 / 10;
    std::nth_element(widths.begin(), widths.begin() + static_cast<std::ptrdiff_t>(at), widths.end());
    m_cell = std::max(widths[at], kSmallestCell);
    m_count = boxes.size();
}

void PairGrid::sortIntoBuckets(std::span<const Box3> boxes) {
    std::size_t buckets = 16;
    while (buckets < 2 * boxes.size()) buckets *= 2;
    m_begin.assign(buckets + 1, 0);
    m_at.resize(boxes.size());
    m_bucket.resize(boxes.size());
    m_large.clear();
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
        const Box3& b = boxes[i];
        if (widest(b) > m_cell) {
            m_large.push_back(i);
            m_bucket[i] = kLarge;
            continue;
        }
        m_at[i] = {static_cast<std::int64_t>(std::floor((b.lo[0] + b.hi[0]) / 2 / m_cell)),
                   static_cast<std::int64_t>(std::floor((b.lo[1] + b.hi[1]) / 2 / m_cell))};
        m_bucket[i] = static_cast<std::uint32_t>(hashCell(m_at[i].first, m_at[i].second) & (buckets - 1));
        ++m_begin[m_bucket[i] + 1];
    }
    for (std::size_t k = 1; k <= buckets; ++k) m_begin[k] += m_begin[k - 1];
    m_items.resize(boxes.size());
    // Fills each bucket's range from its end; afterwards the start indices are correct again.
    for (std::uint32_t i = static_cast<std::uint32_t>(boxes.size()); i-- > 0;)
        if (m_bucket[i] != kLarge) m_items[--m_begin[m_bucket[i] + 1]] = i;
    for (std::size_t k = 0; k < buckets; ++k) m_begin[k] = m_begin[k + 1];
    m_begin[buckets] = static_cast<std::uint32_t>(boxes.size() - m_large.size());
}

void PairGrid::pairsOf(std::uint32_t i, std::span<const Box3> boxes, std::vector<IndexPair>& out) const {
    static constexpr int kAround[5][2] = {{0, 0}, {1, 0}, {-1, 1}, {0, 1}, {1, 1}};
    const std::size_t mask = m_begin.size() - 2;
    for (const auto& step : kAround) {
        const std::pair<std::int64_t, std::int64_t> cell{m_at[i].first + step[0], m_at[i].second + step[1]};
        const std::size_t bucket = hashCell(cell.first, cell.second) & mask;
        for (std::uint32_t k = m_begin[bucket]; k < m_begin[bucket + 1]; ++k) {
            const std::uint32_t j = m_items[k];
            if (m_at[j] != cell || (cell == m_at[i] && j <= i) || !boxes[i].touches(boxes[j])) continue;
            out.emplace_back(std::min(i, j), std::max(i, j));
        }
    }
}

void PairGrid::file(std::span<const Box3> boxes) {
    if (boxes.size() < 2) return;
    if (m_count != boxes.size()) chooseCell(boxes);
    sortIntoBuckets(boxes);
}

void PairGrid::partnersOf(std::uint32_t i, std::span<const Box3> boxes, std::vector<std::uint32_t>& out) const {
    out.clear();
    if (boxes.size() < 2) return;
    const Box3& own = boxes[i];
    const auto take = [&](std::uint32_t j) {
        if (j > i && own.touches(boxes[j])) out.push_back(j);
    };
    if (m_bucket[i] == kLarge) {
        for (std::uint32_t j = i + 1; j < boxes.size(); ++j) take(j);
        return;
    }
    const std::size_t mask = m_begin.size() - 2;
    for (std::int64_t y = m_at[i].second - 1; y <= m_at[i].second + 1; ++y)
        for (std::int64_t x = m_at[i].first - 1; x <= m_at[i].first + 1; ++x) {
            const std::size_t bucket = hashCell(x, y) & mask;
            for (std::uint32_t k = m_begin[bucket]; k < m_begin[bucket + 1]; ++k)
                if (const std::uint32_t j = m_items[k]; m_at[j] == std::pair(x, y)) take(j);
        }
    for (const std::uint32_t j : m_large) take(j);
    if (out.size() > 1) std::sort(out.begin(), out.end());
}

void PairGrid::pairs(std::span<const Box3> boxes, std::vector<IndexPair>& out) {
    out.clear();
    if (boxes.size() < 2) return;
    file(boxes);
    for (std::uint32_t i = 0; i < boxes.size(); ++i)
        if (m_bucket[i] != kLarge) pairsOf(i, boxes, out);
    for (const std::uint32_t i : m_large)
        for (std::uint32_t j = 0; j < boxes.size(); ++j) {
            const bool bothLarge = m_bucket[j] == kLarge;
            if (i == j || (bothLarge && j < i) || !boxes[i].touches(boxes[j])) continue;
            out.emplace_back(std::min(i, j), std::max(i, j));
        }
    std::sort(out.begin(), out.end());
}

} // namespace trundle
