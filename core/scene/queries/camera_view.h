#pragma once
// Pose and lens of a virtual camera, and the pinhole projection of world points to pixels.

#include <cstdint>
#include <numbers>
#include <optional>

#include <trundle/geometry.h>

#include "scene/shapes/bounds.h"

namespace trundle {

struct CameraView {
    Vec3 eye{3, -4, 3};
    Vec3 target = Vec3::Zero();
    Vec3 up = Vec3::UnitZ();
    double fieldOfView = 50 * std::numbers::pi / 180; ///< rad, horizontal, in (0, pi)
    double orthographicWidth = 0;                     ///< m; above 0: parallel projection of this width
    double nearPlane = 0, farPlane = 0;               ///< m; 0: chosen from the scene
};

/// True if all numbers are finite, eye and target differ and the field of view is in (0, pi).
[[nodiscard]] bool isUsable(const CameraView& view);

/// Rounded to a micrometre, one metre ahead as at the eye: a camera that rests on something takes all its pictures from one place.
[[nodiscard]] CameraView settled(const CameraView& view);

/// Camera axes in world coordinates; columns: right, up, backwards. An `up` parallel to the line of sight is replaced.
[[nodiscard]] Mat3 cameraAxes(const CameraView& view);

/// Pixels from the left and from the top; (0, 0) is the top left corner of the top left pixel. `depth` is measured along the
/// optical axis (m). project() returns nullopt for points behind the camera.
struct ImagePoint {
    double x = 0, y = 0, depth = 0;
};
[[nodiscard]] std::optional<ImagePoint> project(const CameraView& view, std::uint32_t width, std::uint32_t height,
                                                const Vec3& point);

/// A ray through a point of the image, in world coordinates.
struct ViewRay {
    Vec3 origin = Vec3::Zero(), direction = Vec3::UnitX();
};
[[nodiscard]] ViewRay rayThrough(const CameraView& view, std::uint32_t width, std::uint32_t height, double x, double y);

/// A raised three-quarter view that contains all of `bounds` with a small margin.
[[nodiscard]] CameraView viewOf(const Bounds& bounds, std::uint32_t width, std::uint32_t height);

} // namespace trundle
