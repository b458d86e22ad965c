#pragma once
#include <cstdint>

#include "model/experiment_spec.h"
#include "scene/poses.h"
#include "scene/view.h"

namespace trundle {

/// A good picture of an experiment where nobody said from where: all robots, and of the statics what is near them.
[[nodiscard]] CameraView defaultView(const ExperimentSpec& experiment, const BodyPoses& poses, std::uint32_t width,
                                     std::uint32_t height);

} // namespace trundle
