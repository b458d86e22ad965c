#pragma once
// Who is near a place, from a uniform grid over the floor.

#include <cstdint>
#include <unordered_map>
#include <vector>

#include <trundle/geometry.h>

#include "radio/radio_trace.h"

namespace trundle {

class Neighbours {
public:
    /// Edge of a cell, m. To be called before the first radio is put anywhere.
    void setCell(double edge) { m_edge = edge; }
    void put(RadioId id, const Vec3& place);
    /// All within `range` and some beyond, rising.
    void near(const Vec3& place, double range, std::vector<RadioId>& out) const;

private:
    [[nodiscard]] std::int64_t column(double x) const;
    [[nodiscard]] static std::uint64_t cellOf(std::int64_t x, std::int64_t y);
    struct Seat {
        std::uint64_t cell = 0;
        bool taken = false;
    };
    double m_edge = 50;
    std::vector<Seat> m_seats;                                       ///< by id
    std::unordered_map<std::uint64_t, std::vector<RadioId>> m_cells; ///< looked up, never walked
};

} // namespace trundle
