#pragma once
// The byte stream from trundle-meshreader to this library: little-endian, a magic number, two counts, then the values.
//   mesh:   "TRMESH02" u32 points, u32 triangles, points x 3 f64 [m], triangles x 3 u32; then the optional appearance
//           (mesh_appearance_stream.h)
//   colour: "TRRGB001" u32 columns, u32 rows, columns x rows x 3 u8, top row first
//   grey:   "TRGREY01" u32 columns, u32 rows, columns x rows f32 [0..1], top row first

#include <string>
#include <string_view>

#include "assets/stream_limits.h"
#include "base/raster.h"
#include "base/result.h"
#include "base/triangle_mesh.h"

namespace trundle {

[[nodiscard]] std::string encodeMesh(const TriangleMesh& mesh);
[[nodiscard]] std::string encodeHeightMap(const HeightMap& map);
[[nodiscard]] std::string encodeRaster(const Raster& raster);

/// Validates all input: counts against the limits and the available bytes, finite numbers, indices in range, at least one
/// triangle (at least 2 x 2 heights, all in 0..1). The error message does not name the file.
[[nodiscard]] Result<TriangleMesh> decodeMesh(std::string_view bytes);
[[nodiscard]] Result<HeightMap> decodeHeightMap(std::string_view bytes);
[[nodiscard]] Result<Raster> decodeRaster(std::string_view bytes);

} // namespace trundle
