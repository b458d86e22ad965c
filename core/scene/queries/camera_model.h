#pragma once
// Camera models of an experiment for rendering: the pose of each camera and how its lens maps the world to pixels.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "model/experiment_spec.h"
#include "scene/queries/camera_view.h"
#include "scene/queries/poses.h"

namespace trundle {

enum class CameraMode : std::uint8_t { Colour, Grey, Depth, Segmentation };

struct CameraModel {
    std::string path, robot; ///< "robot0/eye", "robot0"
    std::size_t body = 0;    ///< index into BodyPoses of the body it is mounted on
    Pose mounting;           ///< X_BC: camera frame C in its body B; x is the viewing direction, z is up
    std::uint32_t width = 320, height = 240;
    double fieldOfView = 1; ///< rad, horizontal, of the undistorted lens
    double nearPlane = 0.05, farPlane = 100;
    CameraMode mode = CameraMode::Colour;
    double noise = 0, exposure = 1;
    double k1 = 0, k2 = 0; ///< radial distortion coefficients
    bool seesSelf = true;
};

/// Robots in text order, and for each robot its cameras in text order.
[[nodiscard]] std::vector<CameraModel> camerasOf(const ExperimentSpec& experiment);

/// The view of the camera while its body is at pose `body` (X_WB), without lens distortion.
[[nodiscard]] CameraView viewOf(const CameraModel& camera, const Pose& body);

/// For each pixel of a distorted camera image, its source position in a larger undistorted image.
struct LensMap {
    struct Source {
        float x = -1, y = -1; ///< pixels in the undistorted image, from its top left corner; negative: no light arrives here
    };
    std::uint32_t width = 0, height = 0; ///< pixels, of the undistorted image
    double fieldOfView = 1;              ///< rad, horizontal, of the undistorted image
    std::vector<Source> sources;         ///< one entry per camera pixel, rows from the top
};

/// Returns nullopt if the lens has no distortion.
[[nodiscard]] std::optional<LensMap> lensMapOf(const CameraModel& camera);

} // namespace trundle
