#pragma once
#include <string>

#include "model/experiment_spec.h"
#include "scene/camera_model.h"
#include "signals/frame.h"

namespace trundle {

/// "time = 0.5 s; tick = 50; camera = robot0/eye; ...": what a picture file says of itself. `camera` may be null.
[[nodiscard]] std::string pictureNote(const Frame& frame, const CameraModel* camera, const SettingsSpec& settings);

/// The bytes of a PNG or JPEG file with a comment put in.
[[nodiscard]] std::string withNote(std::string file, const std::string& note);

} // namespace trundle
