#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "model/experiment_spec.h"
#include "scene/queries/camera_view.h"
#include "scene/queries/poses.h"

namespace trundle {

/// The View block of that name, evaluated for these body poses; nullopt if there is none.
[[nodiscard]] std::optional<CameraView> namedView(const ExperimentSpec& experiment, std::string_view name,
                                                  const BodyPoses& poses);
/// The View of that name in another text of the experiment that runs, as one that was edited since; the robots and poses are the run's.
[[nodiscard]] std::optional<CameraView> namedView(const ExperimentSpec& text, std::string_view name,
                                                  const ExperimentSpec& running, const BodyPoses& poses);
/// "top, side": the names of the experiment's Views.
[[nodiscard]] std::string viewNames(const ExperimentSpec& experiment);

/// Default view of an experiment, used when no View is given: all robots, and the statics near them.
[[nodiscard]] CameraView defaultView(const ExperimentSpec& experiment, const BodyPoses& poses, std::uint32_t width,
                                     std::uint32_t height);

} // namespace trundle
