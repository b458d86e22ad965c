#pragma once
// Selects the robots and signals of a log.

#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.h"
#include "model/experiment_spec.h"
#include "signals/layout.h"

namespace trundle {

/// `*` matches any characters, including none and `/`; `?` matches one character.
[[nodiscard]] bool matchesWildcard(std::string_view pattern, std::string_view text);

/// Indices, in increasing order, of the robots selected by `Robot`: names, wildcards, or the name of a Grid or Scatter for all
/// its members. All robots if none is given. A name that matches no robot is an error.
[[nodiscard]] std::vector<std::size_t> chooseRobots(const ComponentSpec& spec, const std::vector<RobotSpec>& robots,
                                                    Diagnostics& diagnostics);

/// The signals selected by `Signals`, in text order, each once. A name that matches no signal is an error.
[[nodiscard]] std::vector<SignalEntry> chooseSignals(const ComponentSpec& spec, const SignalLayout& layout,
                                                     Diagnostics& diagnostics);

} // namespace trundle
