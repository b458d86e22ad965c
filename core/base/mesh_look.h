#pragma once
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "base/raster.h"

namespace trundle {

/// Colours as shown on a screen.
struct MeshMaterial {
    std::array<float, 3> colour{0.8f, 0.8f, 0.8f}, emission{0, 0, 0};
    float opacity = 1, shininess = 0;
    std::shared_ptr<const Raster> picture; ///< in place of the colour; null where there is none
};

/// How a mesh looks by its own file.
struct MeshLook {
    std::vector<MeshMaterial> materials;
    std::vector<std::uint16_t> material; ///< of each triangle
    /// Of the corners of each triangle: (0, 0) is the top left corner of the picture, (1, 1) the lower right one. Empty where no
    /// material has a picture.
    std::vector<std::array<std::array<float, 2>, 3>> onPicture;
    std::vector<std::string> complaints; ///< what of it is missing or broken, a line each
};

} // namespace trundle
