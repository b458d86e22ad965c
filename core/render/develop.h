#pragma once
// From what was drawn to what a camera gives: lens, exposure, grey, noise. A function of its arguments alone.

#include <optional>

#include "render/image.h"
#include "render/measured.h"
#include "scene/camera_model.h"
#include "signals/frame.h"

namespace trundle {

/// `drawn` is as large as the lens map says, or as the camera where there is none.
[[nodiscard]] Frame developed(const CameraModel& camera, const std::optional<LensMap>& lens, Image drawn);
[[nodiscard]] Frame developed(const CameraModel& camera, const std::optional<LensMap>& lens, Measured drawn);

/// Adds what the sensor itself adds. Depends on seed, camera and frame.tick alone.
void addNoise(const CameraModel& camera, std::uint64_t seed, Frame& frame);

} // namespace trundle
