#pragma once
#include <string>

#include "model/experiment_spec.h"
#include "scene/queries/camera_model.h"
#include "signals/camera_image.h"

namespace trundle {

/// Comment of an image file: "time = 0.5 s; tick = 50; camera = robot0/eye; ...". `camera` may be null.
[[nodiscard]] std::string imageMetadata(const CameraImage& frame, const CameraModel* camera, const SettingsSpec& settings);

/// The bytes of a PNG or JPEG file with a comment inserted.
[[nodiscard]] std::string withMetadata(std::string file, const std::string& note);

} // namespace trundle
