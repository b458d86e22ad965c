#pragma once
// What an edit of the document means for a world that runs: some values reach it as commands, the others wait for a reset.

#include <memory>
#include <string>
#include <vector>

#include "project/project.h"
#include "run/command.h"

namespace trundle {

struct LiveEdits {
    std::vector<decltype(Command::what)> commands;
    std::shared_ptr<const ExperimentSpec> experiment; ///< what runs, with the live changes in it; null where there are none
    std::vector<std::string> waiting;                 ///< dotted paths of all that differs from `built` and is not live
};

/// `running` is what was built with the live edits made since.
[[nodiscard]] LiveEdits liveEdits(const Loaded& built, const ExperimentSpec& running, const Loaded& now);

} // namespace trundle
