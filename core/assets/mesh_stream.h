#pragma once
// The bytes that trundle-meshreader writes and assets reads: little-endian, a magic, two counts, then the numbers.
//   mesh:   "TRMESH02" u32 points, u32 triangles, points x 3 f64 [m], triangles x 3 u32; then, if any, its look (mesh_look_stream.h)
//   colour: "TRRGB001" u32 columns, u32 rows, columns x rows x 3 u8, top row first
//   grey:   "TRGREY01" u32 columns, u32 rows, columns x rows f32 [0..1], top row first

#include <string>
#include <string_view>

#include "assets/mesh_look_stream.h"
#include "base/raster.h"
#include "base/result.h"
#include "base/triangle_mesh.h"

namespace trundle {

inline constexpr std::uint32_t kMostMeshPoints = 4'000'000;
inline constexpr std::uint32_t kMostMeshTriangles = 1'000'000;
inline constexpr std::uint32_t kMostGreySide = 16'384;
inline constexpr std::uint32_t kMostRasterSide = 2048;
inline constexpr std::uint64_t kMostGreyPoints = 16'777'216; ///< 4096 x 4096
/// No mesh and no picture is longer than this.
inline constexpr std::uint64_t kMostStreamBytes =
    16 + 24ull * kMostMeshPoints + 38ull * kMostMeshTriangles + kMostMeshPictureBytes + (1u << 20);

[[nodiscard]] std::string encodeMesh(const TriangleMesh& mesh);
[[nodiscard]] std::string encodeHeightMap(const HeightMap& map);
[[nodiscard]] std::string encodeRaster(const Raster& raster);

/// Believe nothing: counts against the limits and against the bytes there are, every number finite, every index inside, at least one
/// triangle (at least 2 x 2 heights, all in 0..1). The message says what is wrong, without naming the file.
[[nodiscard]] Result<TriangleMesh> decodeMesh(std::string_view bytes);
[[nodiscard]] Result<HeightMap> decodeHeightMap(std::string_view bytes);
[[nodiscard]] Result<Raster> decodeRaster(std::string_view bytes);

} // namespace trundle
