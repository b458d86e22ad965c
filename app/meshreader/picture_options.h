#pragma once
#include <array>
#include <map>
#include <string>
#include <string_view>

namespace trundle {

/// Where the picture of a material lies: places on it are multiplied by `scale`, then `offset` is added.
struct PicturePlacement {
    std::array<float, 2> scale{1, 1}, offset{0, 0};
};

/// The text of an OBJ's file of materials with the options of `map_Kd` taken out, for assimp expects three numbers where one or two
/// may stand and loses the name after them. What they say of the place goes to `placements`, by the name of the material.
[[nodiscard]] std::string withoutPictureOptions(std::string_view materials, std::map<std::string, PicturePlacement>& placements);

} // namespace trundle
