#pragma once
#include <memory>
#include <string>
#include <vector>

#include "base/diagnostic.h"
#include "project/loading/loaded_project.h"

namespace trundle {

struct LiveSnapshot;

/// A place in the source of a controller.
struct CodePlace {
    std::string file; ///< absolute; empty: unknown
    int line = 0;     ///< from 1
};

/// Of each problem, where the controller's code has the fault.
[[nodiscard]] std::vector<CodePlace> codePlacesOf(const std::vector<Diagnostic>& problems, const LiveSnapshot* snapshot);

/// Problems of a run, and the texts that their ranges are in.
struct ProblemsInCode {
    std::vector<Diagnostic> problems;
    std::shared_ptr<const LoadedProject> texts;
};
/// The problems, whose ranges are in `built`, with those of code in its source if that is in the project's folder and can be read; a
/// note then leads to the controller's block. `places`: of each problem.
[[nodiscard]] ProblemsInCode shownInCode(std::vector<Diagnostic> problems, const std::vector<CodePlace>& places,
                                         std::shared_ptr<const LoadedProject> built);

} // namespace trundle
