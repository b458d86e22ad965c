#pragma once
#include <memory>
#include <vector>

#include "base/diagnostic.h"
#include "project/loading/loaded_project.h"

namespace trundle {

/// The modules in Python that did not load (E414), each at the line of its source that the message names; a note leads to its #loadModule.
/// Those whose line is not in the project's folder stay there.
struct PythonProblems {
    std::vector<Diagnostic> found;
    std::shared_ptr<const LoadedProject> texts; ///< that the ranges are in
};
[[nodiscard]] PythonProblems pythonProblemsOf(const std::shared_ptr<const LoadedProject>& loaded);

} // namespace trundle
