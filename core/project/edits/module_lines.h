#pragma once
// Plans edits of the #loadModule lines of an experiment.

#include <string>
#include <vector>

#include "project/edits/plans.h"

namespace trundle {

[[nodiscard]] Result<EditPlan> planLoadModule(const LoadedProject& loaded, const std::string& written);
/// Removes the #loadModule `written` of a file. Fails if it has none.
[[nodiscard]] Result<EditPlan> planUnloadModule(const LoadedProject& loaded, FileId file, const std::string& written);

/// The path that a #loadModule of the opened file uses for a library: relative to `shippedModules` (the program's folder), the
/// file's own folder or one of `moduleFolders` (those of the command line), or by `../` to another folder of the project. Absolute
/// if it is outside of all these.
[[nodiscard]] std::string writtenFor(const std::string& library, const LoadedProject& loaded, const std::string& shippedModules,
                                     const std::vector<std::string>& moduleFolders = {});

} // namespace trundle
