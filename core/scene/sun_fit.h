#pragma once
// Which part of space a picture of the sun's view has to show, so that everything in a picture knows whether the sun reaches it.

#include <cstdint>
#include <optional>
#include <vector>

#include "scene/bounds.h"
#include "scene/view.h"

namespace trundle {

/// What the sun sees: a box along its light.
struct SunFit {
    Mat3 axes = Mat3::Identity(); ///< in the world: columns right, up, towards the sun
    Vec3 origin = Vec3::Zero();   ///< along those axes: left, lower and sunny corner (m)
    double width = 1, height = 1, depth = 1;
    [[nodiscard]] double texel(std::uint32_t pixels) const { return std::max(width, height) / pixels; } ///< m
};

/// The part of `casters` (boxes in the world) whose shadow can be in the picture, and no more of it than the picture shows; nothing where
/// there is none. It grows in steps and stands on a grid of its own pixels, so that edges of shadows hold still while a view moves.
[[nodiscard]] std::optional<SunFit> fitSun(const Vec3& sun, const std::vector<Bounds>& casters, const CameraView& view,
                                           std::uint32_t width, std::uint32_t height, std::uint32_t pixels);

} // namespace trundle
