#pragma once
#include <cstdint>
#include <vector>

namespace trundle {

/// A texture image: RGB, 8 bits per channel, sRGB; rows from the top. At least 1 x 1.
struct Raster {
    std::uint32_t width = 0, height = 0;
    std::vector<std::uint8_t> pixels; ///< width * height * 3
};

} // namespace trundle
