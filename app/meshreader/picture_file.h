#pragma once
#include <string>

#include "base/raster.h"
#include "base/result.h"
#include "base/triangle_mesh.h"

namespace trundle {

/// Reads a picture as a height map: black is 0, white is 1, colours by luminance. Error messages do not contain the file name.
[[nodiscard]] Result<HeightMap> readPictureFile(const std::string& path);
/// Reads a picture in colour; scaled down if a side has more than kMaxRasterSide pixels.
[[nodiscard]] Result<Raster> readColourFile(const std::string& path);
/// The same for a picture in memory.
[[nodiscard]] Result<Raster> readColours(const std::string& content);

} // namespace trundle
