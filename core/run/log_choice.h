#pragma once
// Which robots and which signals a log means.

#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.h"
#include "model/experiment_spec.h"
#include "signals/layout.h"

namespace trundle {

/// `*` stands for any characters, also none and also `/`; `?` for one.
[[nodiscard]] bool matchesWildcard(std::string_view pattern, std::string_view text);

/// Indices of the robots under `Robot`, rising: names, wildcards, or a Grid's or Scatter's name for all its members. All robots where
/// nothing is named. A name that means no robot is an error.
[[nodiscard]] std::vector<std::size_t> chooseRobots(const ComponentSpec& spec, const std::vector<RobotSpec>& robots,
                                                    Diagnostics& diagnostics);

/// The signals under `Signals`, in the text's order, each once. A name that means no signal is an error.
[[nodiscard]] std::vector<const SignalEntry*> chooseSignals(const ComponentSpec& spec, const SignalLayout& layout,
                                                            Diagnostics& diagnostics);

} // namespace trundle
