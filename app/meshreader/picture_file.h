#pragma once
#include <string>

#include "base/raster.h"
#include "base/result.h"
#include "base/triangle_mesh.h"

namespace trundle {

/// Reads a picture as heights: black 0, white 1, colours by their brightness. The message does not name the file.
[[nodiscard]] Result<HeightMap> readPictureFile(const std::string& path);
/// Reads it in colour; one with more than kMostRasterSide pixels along a side is made smaller.
[[nodiscard]] Result<Raster> readColourFile(const std::string& path);
/// The same of a picture in memory.
[[nodiscard]] Result<Raster> readColours(const std::string& content);

} // namespace trundle
