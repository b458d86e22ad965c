#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "render/image.h"

namespace trundle {

/// Style of outlines; display colours.
struct OutlineStyle {
    std::array<std::uint8_t, 3> selected{255, 140, 0}, hovered{255, 255, 255};
    float width = 2; ///< pixels
};

/// `coverage`: 4 bytes per pixel, rows from the top; red: selected objects, green: hovered ones. Draws an antialiased line around
/// each, outside of it. The cost is proportional to the length of the outlines, not to the image size.
void drawOutlines(Image& image, const std::vector<std::uint8_t>& coverage, const OutlineStyle& style);

} // namespace trundle
