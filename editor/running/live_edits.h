#pragma once
// The effect of document edits on a running world: live properties are sent as commands, other changes wait for a reset.

#include <memory>
#include <string>
#include <vector>

#include "project/loading/project.h"
#include "run/command.h"

namespace trundle {

struct LiveEdits {
    std::vector<decltype(Command::what)> commands;
    std::shared_ptr<const ExperimentSpec> experiment; ///< the running one with the live changes; null: none
    std::vector<std::string> waiting;                 ///< dotted paths of all other differences from `built`
};

/// `running`: the experiment as built, with the live edits made since.
[[nodiscard]] LiveEdits liveEdits(const LoadedProject& built, const ExperimentSpec& running, const LoadedProject& now);

} // namespace trundle
