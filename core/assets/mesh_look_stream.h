#pragma once
// The end of a mesh's stream: how it looks.

#include <memory>
#include <string>
#include <string_view>

#include "base/mesh_look.h"
#include "base/result.h"

namespace trundle {

inline constexpr std::uint32_t kMostMeshMaterials = 1024, kMostMeshPictures = 64;
inline constexpr std::uint64_t kMostMeshPictureBytes = 128u << 20; ///< of all pictures of a mesh
inline constexpr std::size_t kMostComplaints = 16, kMostComplaintBytes = 300;

/// u32 materials, u32 pictures, u32 complaints, u32 1 where triangles lie on pictures; of each material 8 x f32 (colour, emission,
/// opacity, shininess) and u32 picture (0: none, else its number from 1); of each triangle u16 and, if so, 6 x f32; of each picture u32
/// width, u32 height, width x height x 3 u8; of each complaint u32 length and its bytes.
[[nodiscard]] std::string encodeLook(const MeshLook& look);
/// Believes nothing, as decodeMesh().
[[nodiscard]] Result<std::shared_ptr<const MeshLook>> decodeLook(std::string_view bytes, std::size_t triangles);

} // namespace trundle
