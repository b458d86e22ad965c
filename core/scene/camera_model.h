#pragma once
// The cameras of an experiment as whoever draws sees them: where each is and how its lens maps the world to pixels.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "model/experiment_spec.h"
#include "scene/poses.h"
#include "scene/view.h"

namespace trundle {

enum class CameraMode : std::uint8_t { Colour, Grey, Depth, Segmentation };

struct CameraModel {
    std::string path, robot; ///< "robot0/eye", "robot0"
    std::size_t body = 0;    ///< which of BodyPoses carries it
    Pose mounting;           ///< in that body; it looks along x, z is up
    std::uint32_t width = 320, height = 240;
    double fieldOfView = 1; ///< rad, from the left edge to the right one, of the lens without distortion
    double nearPlane = 0.05, farPlane = 100;
    CameraMode mode = CameraMode::Colour;
    double noise = 0, exposure = 1;
    double k1 = 0, k2 = 0; ///< distortion
    bool seesSelf = true;
};

/// Robots in text order, of each its cameras in text order.
[[nodiscard]] std::vector<CameraModel> camerasOf(const ExperimentSpec& experiment);

/// Where it looks from while its body stands at `body`; without the lens's distortion.
[[nodiscard]] CameraView viewOf(const CameraModel& camera, const Pose& body);

/// Where a lens takes each pixel of its picture from: a picture without distortion, drawn larger.
struct LensMap {
    struct Source {
        float x = -1, y = -1; ///< pixels of the drawn picture, from its top left corner; below 0: nothing gets there
    };
    std::uint32_t width = 0, height = 0; ///< of the picture to draw
    double fieldOfView = 1;              ///< of the picture to draw
    std::vector<Source> sources;         ///< for each pixel of the camera, rows from the top
};

/// Nothing where the lens distorts nothing.
[[nodiscard]] std::optional<LensMap> lensMapOf(const CameraModel& camera);

} // namespace trundle
