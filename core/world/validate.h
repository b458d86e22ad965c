#pragma once
#include "base/diagnostic.h"
#include "model/experiment_spec.h"

namespace trundle {

/// Checks everything the engine assumes: finite numbers in range, positive sizes and masses, valid indices. The resolver reports
/// most of it with better messages; this check also covers experiments that were not made by the resolver.
[[nodiscard]] bool isBuildable(const ExperimentSpec& experiment, Diagnostics& diagnostics);

/// True if contacts can be computed with these values.
[[nodiscard]] bool isSurface(const SurfaceSpec& surface);

/// True if finite, within the allowed distance from the origin, and with a unit rotation.
[[nodiscard]] bool isPosition(const Pose& pose);

} // namespace trundle
