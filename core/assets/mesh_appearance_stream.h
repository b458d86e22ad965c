#pragma once
// The last section of a mesh stream: materials, textures and warnings.

#include <memory>
#include <string>
#include <string_view>

#include "assets/stream_limits.h"
#include "base/mesh_appearance.h"
#include "base/result.h"

namespace trundle {

/// Layout: u32 materials, u32 pictures, u32 warnings, u32 1 if triangles have texture coordinates; per material 8 x f32 (colour,
/// emission, opacity, shininess) and u32 picture (0: none, else its number from 1); per triangle u16 material and, with texture
/// coordinates, 6 x f32; per picture u32 width, u32 height, width x height x 3 u8; per warning u32 length and its bytes.
[[nodiscard]] std::string encodeAppearance(const MeshAppearance& look);
/// Validates all input, as decodeMesh() does.
[[nodiscard]] Result<std::shared_ptr<const MeshAppearance>> decodeAppearance(std::string_view bytes, std::size_t triangles);

} // namespace trundle
