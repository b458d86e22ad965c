#pragma once
#include "model/experiment_spec.h"
#include "model/set_targets.h"

namespace trundle {

/// E323 with the fix that writes a Grid or Scatter out as single robots at their places.
void sayReplaceBySingles(const MemberPath& member, const Outline& outline, const ExperimentSpec& experiment,
                         Diagnostics& diagnostics);

} // namespace trundle
