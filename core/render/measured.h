#pragma once
#include <cstdint>
#include <vector>

namespace trundle {

/// A picture of numbers; rows from the top.
struct Measured {
    std::uint32_t width = 0, height = 0;
    std::vector<float> depth;           ///< m along the camera's axis, infinite where there is nothing
    std::vector<std::uint32_t> objects; ///< as objectNames() counts; 0 where there is nothing
};

} // namespace trundle
