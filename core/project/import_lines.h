#pragma once
#include <string>
#include <vector>

#include "base/text_edit.h"
#include "project/project.h"

namespace trundle {

/// Adds directives to a file ("robots/rover.sim", "#import robots/rover.sim", "#loadModule walker") that it has not got yet, behind
/// its others of that sort. Fails for a path that no line can hold.
[[nodiscard]] Result<std::vector<TextEdit>> editsForImports(const Loaded& loaded, FileId file,
                                                            const std::vector<std::string>& directives);

} // namespace trundle
