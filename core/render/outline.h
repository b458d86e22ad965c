#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "render/image.h"

namespace trundle {

/// How outlines look: colours as shown on a screen.
struct OutlineStyle {
    std::array<std::uint8_t, 3> selected{255, 140, 0}, hovered{255, 255, 255};
    float width = 2; ///< pixels
};

/// Coverage of what is to be outlined: red selected, green hovered; 4 bytes for each pixel, rows from the top.
/// Draws a smooth line around each, outside of it. Its cost is that of the lines, not of the picture.
void drawOutlines(Image& image, const std::vector<std::uint8_t>& coverage, const OutlineStyle& style);

} // namespace trundle
