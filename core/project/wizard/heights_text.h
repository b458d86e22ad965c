#pragma once
// Ground from a grey picture, as text.

#include <array>
#include <string>

#include "base/result.h"
#include "base/triangle_mesh.h"

namespace trundle {

/// A Heightfield of that file. `size`: along x, along y, height of white, m. Fails if a length is out of range.
[[nodiscard]] Result<std::string> heightsText(const std::string& file, const std::array<double, 3>& size);
/// A StaticConfig `name` with that ground.
[[nodiscard]] std::string heightsArenaText(const std::string& name, const std::string& ground);
/// The highest ground within `radius` of a place, m.
[[nodiscard]] double heightAt(const HeightMap& map, const std::array<double, 3>& size, const std::array<double, 2>& place,
                              double radius);

} // namespace trundle
