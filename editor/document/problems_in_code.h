#pragma once
#include <memory>
#include <vector>

#include "base/diagnostic.h"
#include "project/loading/loaded_project.h"

namespace trundle {

/// Problems, and the texts that their ranges are in.
struct ProblemsInCode {
    std::vector<Diagnostic> problems;
    std::shared_ptr<const LoadedProject> texts;
};
/// The problems, whose ranges are in `texts`. One with a place in the source of a module is shown there if that is in the project's
/// folder and can be read; a note then leads to the block that uses it.
[[nodiscard]] ProblemsInCode shownInCode(std::vector<Diagnostic> problems, std::shared_ptr<const LoadedProject> texts);

} // namespace trundle
