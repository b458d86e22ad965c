#pragma once
#include <string>
#include <unordered_map>
#include <utility>

#include "project/loading/project.h"

namespace trundle {

/// Of each Grid and Scatter the numbers of its members, [first, last): those of robots in the experiment, behind them those of scenery.
using RowMembers = std::unordered_map<const Part*, std::pair<std::size_t, std::size_t>>;
[[nodiscard]] RowMembers membersOf(const LoadedProject& loaded);
/// Of a name of a member; else the number behind the last one.
[[nodiscard]] std::size_t numberOfMember(const ExperimentSpec& e, const std::string& name);
[[nodiscard]] const std::string& nameOfMember(const ExperimentSpec& e, std::size_t member);

} // namespace trundle
