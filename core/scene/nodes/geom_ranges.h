#pragma once
#include <algorithm>
#include <cstdint>
#include <iterator>
#include <vector>

#include <osg/Referenced>

namespace trundle {

/// User data of a drawable: the geom of each vertex, so that a hit can be assigned to a geom.
struct GeomRanges : osg::Referenced {
    struct Range {
        std::uint32_t firstVertex, geom;
    };
    std::vector<Range> ranges; ///< ascending
    [[nodiscard]] std::uint32_t geomOf(std::uint32_t vertex) const {
        const auto after = std::upper_bound(ranges.begin(), ranges.end(), vertex,
                                            [](std::uint32_t v, const Range& r) { return v < r.firstVertex; });
        return after == ranges.begin() ? 0 : std::prev(after)->geom;
    }
};

} // namespace trundle
