#pragma once
// Resolves the outline of an experiment into the typed model.

#include <memory>

#include "base/diagnostic.h"
#include "model/asset_lookup.h"
#include "model/experiment_spec.h"
#include "model/outline.h"

namespace trundle {

/// Resolves everything that is valid; reports the rest and leaves it out. The caller fills in the modules.
[[nodiscard]] std::shared_ptr<ExperimentSpec> resolve(const Outline& outline, const AssetLookup& assets,
                                                      Diagnostics& diagnostics);

} // namespace trundle
