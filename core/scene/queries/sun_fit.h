#pragma once
// The region that the sun's shadow map must cover for one image.

#include <cstdint>
#include <optional>
#include <vector>

#include "scene/queries/camera_view.h"
#include "scene/shapes/bounds.h"

namespace trundle {

/// Orthographic box of the shadow map, along the light.
struct SunFit {
    Mat3 axes = Mat3::Identity(); ///< in world coordinates; columns: right, up, towards the sun
    Vec3 origin = Vec3::Zero();   ///< m, along those axes: left, lower corner nearest to the sun
    double width = 1, height = 1, depth = 1;
    [[nodiscard]] double texel(std::uint32_t pixels) const { return std::max(width, height) / pixels; } ///< m per pixel
};

/// Covers the part of `casters` (world boxes) whose shadow can be in the image, limited to what the image shows; nullopt if there
/// is none. Sizes grow in steps and the origin is snapped to the map's pixel grid, so that shadow edges do not flicker while the
/// view moves.
[[nodiscard]] std::optional<SunFit> fitSun(const Vec3& sun, const std::vector<Bounds>& casters, const CameraView& view,
                                           std::uint32_t width, std::uint32_t height, std::uint32_t pixels);

} // namespace trundle
