#pragma once
#include <string>
#include <vector>

#include "base/text_edit.h"
#include "project/loading/loaded_project.h"

namespace trundle {

/// Adds those directives ("robots/rover.sim", "#import robots/rover.sim", "#loadModule walker") that a file does not have yet,
/// after its others of the same type. Fails for a path that cannot be written in one line. `without`: an import that is going to be
/// removed; what only it leads to is not imported yet.
[[nodiscard]] Result<std::vector<TextEdit>> editsForImports(const LoadedProject& loaded, FileId file,
                                                            const std::vector<std::string>& directives,
                                                            const ImportItem* without = nullptr);

} // namespace trundle
