#pragma once
#include "base/diagnostic.h"
#include "model/experiment_spec.h"

namespace trundle {

/// Everything the engine takes for granted: finite numbers of sane size, positive sizes and masses, indices that exist. The
/// resolver refuses most of it with better words; this is the door that also holds for experiments that came another way.
[[nodiscard]] bool isBuildable(const ExperimentSpec& experiment, Diagnostics& diagnostics);

/// Values that contacts can be computed with.
[[nodiscard]] bool isSurface(const SurfaceSpec& surface);

/// Finite, near enough to the origin, unit rotation.
[[nodiscard]] bool isPlace(const Pose& pose);

} // namespace trundle
