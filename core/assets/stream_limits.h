#pragma once
// Limits of what trundle-meshreader may send.

#include <cstddef>
#include <cstdint>

namespace trundle {

inline constexpr std::uint32_t kMaxMeshMaterials = 1024, kMaxMeshPictures = 64;
inline constexpr std::uint64_t kMaxMeshPictureBytes = 128u << 20; ///< all pictures of a mesh together
inline constexpr std::size_t kMaxWarnings = 16, kMaxWarningBytes = 300;

inline constexpr std::uint32_t kMaxMeshPoints = 4'000'000;
inline constexpr std::uint32_t kMaxMeshTriangles = 1'000'000;
inline constexpr std::uint32_t kMaxGreySide = 16'384;
inline constexpr std::uint32_t kMaxRasterSide = 2048;
inline constexpr std::uint64_t kMaxGreyPoints = 16'777'216; ///< 4096 x 4096
/// Upper limit of the length of any mesh or image stream.
inline constexpr std::uint64_t kMaxStreamBytes =
    16 + 24ull * kMaxMeshPoints + 38ull * kMaxMeshTriangles + kMaxMeshPictureBytes + (1u << 20);

} // namespace trundle
