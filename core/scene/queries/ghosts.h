#pragma once
#include <functional>
#include <memory>
#include <string>

#include "model/experiment_spec.h"

namespace trundle {

/// Robots, statics and geoms that `before` had and `now` lacks although their blocks are still in the text (`isWritten`, by
/// dotted path). They are drawn as ghosts at their last poses. Null if nothing is missing.
[[nodiscard]] std::shared_ptr<const ExperimentSpec> ghostsOf(const ExperimentSpec& now, const ExperimentSpec& before,
                                                             const std::function<bool(const std::string& path)>& isWritten);

} // namespace trundle
