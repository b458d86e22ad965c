#pragma once
// Where a picture is taken from, and the pinhole formula that says where a point appears in it.

#include <cstdint>
#include <numbers>
#include <optional>

#include <trundle/geometry.h>

#include "scene/bounds.h"

namespace trundle {

struct CameraView {
    Vec3 eye{3, -4, 3};
    Vec3 target = Vec3::Zero();
    Vec3 up = Vec3::UnitZ();
    double fieldOfView = 50 * std::numbers::pi / 180; ///< rad, horizontal, in (0, pi)
    double orthographicWidth = 0;                     ///< m; above 0 the picture is a parallel projection of that width
    double nearPlane = 0, farPlane = 0;               ///< m; 0: chosen from the scene
};

/// Finite, eye apart from target, field of view in (0, pi).
[[nodiscard]] bool isUsable(const CameraView& view);

/// Camera axes in the world: columns right, up, backwards. An `up` along the line of sight is replaced.
[[nodiscard]] Mat3 cameraAxes(const CameraView& view);

/// Pixels from the left and from the top, (0, 0) being the top left corner of the top left pixel, and the depth along the
/// line of sight (m). Nothing behind the camera.
struct ImagePoint {
    double x = 0, y = 0, depth = 0;
};
[[nodiscard]] std::optional<ImagePoint> project(const CameraView& view, std::uint32_t width, std::uint32_t height,
                                                const Vec3& point);

/// A ray through a point of the picture.
struct ViewRay {
    Vec3 origin = Vec3::Zero(), direction = Vec3::UnitX();
};
[[nodiscard]] ViewRay rayThrough(const CameraView& view, std::uint32_t width, std::uint32_t height, double x, double y);

/// A raised three-quarter view in which the whole of `bounds` is seen with a little room around it.
[[nodiscard]] CameraView viewOf(const Bounds& bounds, std::uint32_t width, std::uint32_t height);

} // namespace trundle
