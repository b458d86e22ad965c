#pragma once
// Finds radios near a position with a uniform grid over the ground plane.

#include <cstdint>
#include <unordered_map>
#include <vector>

#include <trundle/geometry.h>

#include "radio/radio_trace.h"

namespace trundle {

class Neighbours {
public:
    void put(RadioId id, const Vec3& place);
    /// All radios within `range` (m) and some beyond, in order of their ids.
    void near(const Vec3& place, double range, std::vector<RadioId>& out) const;

private:
    [[nodiscard]] static std::int64_t column(double x);
    [[nodiscard]] static std::uint64_t cellOf(std::int64_t x, std::int64_t y);
    struct CellEntry {
        std::uint64_t cell = 0;
        bool taken = false;
    };
    static constexpr double kEdge = 50;                              ///< of a cell, m
    std::vector<CellEntry> m_entries;                                ///< by radio id
    std::unordered_map<std::uint64_t, std::vector<RadioId>> m_cells; ///< iteration order is never used
};

} // namespace trundle
