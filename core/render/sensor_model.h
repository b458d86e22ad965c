#pragma once
// Converts a rendered image to a camera image: lens distortion, exposure, greyscale, noise. A pure function of its arguments.

#include <optional>

#include "render/data_image.h"
#include "render/image.h"
#include "scene/queries/camera_model.h"
#include "signals/camera_image.h"

namespace trundle {

/// `drawn` has the size of the lens map, or of the camera if there is none.
[[nodiscard]] CameraImage applySensorModel(const CameraModel& camera, const std::optional<LensMap>& lens, Image drawn);
[[nodiscard]] CameraImage applySensorModel(const CameraModel& camera, const std::optional<LensMap>& lens, DataImage drawn);

/// Adds sensor noise. Depends only on seed, camera and frame.tick.
void addNoise(const CameraModel& camera, std::uint64_t seed, CameraImage& frame);

} // namespace trundle
