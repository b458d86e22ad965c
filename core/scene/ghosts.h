#pragma once
#include <functional>
#include <memory>
#include <string>

#include "model/experiment_spec.h"

namespace trundle {

/// What `before` had and `now` has lost although its text is still there (`isWritten`, by dotted path): robots, statics and
/// geoms, to be drawn as ghosts where they last stood. Null where nothing is lost.
[[nodiscard]] std::shared_ptr<const ExperimentSpec> ghostsOf(const ExperimentSpec& now, const ExperimentSpec& before,
                                                             const std::function<bool(const std::string& path)>& isWritten);

} // namespace trundle
