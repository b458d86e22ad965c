#pragma once
#include <cstdint>
#include <vector>

namespace trundle {

/// An image of depths and object numbers; rows from the top.
struct DataImage {
    std::uint32_t width = 0, height = 0;
    std::vector<float> depth;           ///< m along the optical axis; infinity where there is no surface
    std::vector<std::uint32_t> objects; ///< numbered as in objectNames(); 0 where there is no surface
};

} // namespace trundle
