#pragma once
#include "model/experiment_spec.h"
#include "model/set_targets.h"

namespace trundle {

/// Reports E323, with the fix that replaces a Grid or Scatter by single robots at the poses of its members.
void reportReplaceBySingles(const MemberPath& member, const Outline& outline, const ExperimentSpec& experiment,
                            Diagnostics& diagnostics);

} // namespace trundle
