#pragma once
#include <cstdint>
#include <vector>

namespace trundle {

/// A picture to lay on surfaces: red, green, blue, 8 bits each as shown on a screen; rows from the top. At least 1 x 1.
struct Raster {
    std::uint32_t width = 0, height = 0;
    std::vector<std::uint8_t> pixels; ///< width * height * 3
};

} // namespace trundle
