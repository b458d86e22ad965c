#include "radio/neighbours.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace trundle {

std::int64_t Neighbours::column(double x) { return static_cast<std::int64_t>(std::floor(std::clamp(x, -1e9, 1e9) / kEdge)); }

std::uint64_t Neighbours::cellOf(std::int64_t x, std::int64_t y) {
    return static_cast<std::uint64_t>(x) << 32 ^ static_cast<std::uint32_t>(y);
}

void Neighbours::put(RadioId id, const Vec3& place) {
    if (id >= m_entries.size()) m_entries.resize(id + 1);
    CellEntry& entry = m_entries[id];
    const std::uint64_t cell = cellOf(column(place.x()), column(place.y()));
    if (entry.taken && entry.cell == cell) return;
    if (entry.taken) std::erase(m_cells[entry.cell], id);
    entry = {cell, true};
    m_cells[cell].push_back(id);
}

void Neighbours::near(const Vec3& place, double range, std::vector<RadioId>& out) const {
    out.clear();
    const std::int64_t left = column(place.x() - range), right = column(place.x() + range);
    const std::int64_t low = column(place.y() - range), high = column(place.y() + range);
    const double cells = static_cast<double>(right - left + 1) * static_cast<double>(high - low + 1);
    if (cells > static_cast<double>(m_cells.size())) { // more cells than are occupied
        out.resize(m_entries.size());
        std::iota(out.begin(), out.end(), 0u);
        return;
    }
    for (std::int64_t x = left; x <= right; ++x)
        for (std::int64_t y = low; y <= high; ++y)
            if (const auto it = m_cells.find(cellOf(x, y)); it != m_cells.end())
                out.insert(out.end(), it->second.begin(), it->second.end());
    std::sort(out.begin(), out.end());
}

} // namespace trundle
