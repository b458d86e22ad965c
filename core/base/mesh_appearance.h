#pragma once
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "base/raster.h"

namespace trundle {

/// Colours in sRGB, as displayed.
struct MeshMaterial {
    std::array<float, 3> colour{0.8f, 0.8f, 0.8f}, emission{0, 0, 0};
    float opacity = 1, shininess = 0;
    std::shared_ptr<const Raster> picture; ///< replaces the colour; null if there is none
};

/// The appearance of a mesh as defined in its own file.
struct MeshAppearance {
    std::vector<MeshMaterial> materials;
    std::vector<std::uint16_t> material; ///< material index of each triangle
    /// Texture coordinates of the corners of each triangle: (0, 0) is the upper left corner of the picture, (1, 1) the lower
    /// right. Empty if no material has a picture.
    std::vector<std::array<std::array<float, 2>, 3>> onPicture;
    std::vector<std::string> warnings; ///< missing or broken parts of the appearance, one line each
};

} // namespace trundle
