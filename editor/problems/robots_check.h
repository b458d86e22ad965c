#pragma once
// Whether robots, devices and controllers can be set up: ports that a robot lacks, values that a module refuses. Only code of the
// modules can say so, and it may crash or loop; it runs in a process of its own, without a step of the simulation.

#include <stop_token>
#include <string>
#include <vector>

#include "app/open_options.h"
#include "base/diagnostic.h"
#include "project/loading/project.h"

namespace trundle {

struct RobotsCheck {
    std::string program; ///< path of trundle-cli; empty: there is no such check
    OpenOptions options; ///< search folders and trusted modules
    double seconds = 10; ///< then it ends with a warning
};

/// What a run of these texts would refuse. Empty without modules, if the process does not start, and after a request to stop.
/// Blocks.
[[nodiscard]] std::vector<Diagnostic> checkRobots(const RobotsCheck& check, const LoadedProject& loaded,
                                                  const std::stop_token& stop);

} // namespace trundle
