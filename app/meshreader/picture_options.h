#pragma once
#include <array>
#include <map>
#include <string>
#include <string_view>

namespace trundle {

/// Transformation of a material's texture coordinates: multiplied by `scale`, then `offset` is added.
struct TextureTransform {
    std::array<float, 2> scale{1, 1}, offset{0, 0};
};

/// The text of an MTL file without the options of `map_Kd`, because assimp requires three numbers where one or two are allowed
/// and then loses the file name. Scale and offset are stored in `placements` by material name.
[[nodiscard]] std::string withoutPictureOptions(std::string_view materials, std::map<std::string, TextureTransform>& placements);

} // namespace trundle
