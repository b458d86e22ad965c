#include "world/reflectance.h"

#include <algorithm>

namespace trundle {

namespace {

constexpr std::uint32_t kSamples = 64; // along each side of a texture

double luminance(double red, double green, double blue) {
    return 0.2126 * red * red + 0.7152 * green * green + 0.0722 * blue * blue;
}

double averageOf(const Raster& picture) {
    const std::uint32_t columns = std::min(kSamples, picture.width), rows = std::min(kSamples, picture.height);
    double sum = 0;
    for (std::uint32_t j = 0; j < rows; ++j)
        for (std::uint32_t i = 0; i < columns; ++i) {
            const std::size_t y = std::size_t{j} * picture.height / rows, x = std::size_t{i} * picture.width / columns;
            const std::uint8_t* p = &picture.pixels[3 * (y * picture.width + x)];
            sum += luminance(p[0] / 255., p[1] / 255., p[2] / 255.);
        }
    return sum / (static_cast<double>(columns) * rows);
}

} // namespace

double reflectanceOf(const MaterialSpec& material) {
    const auto& c = material.colour;
    return std::clamp(luminance(c[0], c[1], c[2]) * (material.picture ? averageOf(*material.picture) : 1), 0., 1.);
}

} // namespace trundle
