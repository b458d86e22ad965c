#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "schema/kind.h"

namespace trundle {

/// Whether a module is a Python file, which runs in a process of its own, always.
[[nodiscard]] inline bool isPythonModule(std::string_view library) { return library.ends_with(".py"); }

/// The kinds that a Python file had when it was last described, from the user's cache; empty if one of the files that it consists of
/// has changed since, or if it was never described. Runs no code of it.
[[nodiscard]] std::optional<std::vector<Kind>> cachedPythonKinds(const std::string& file);
/// Keeps a description that the Python package has made. Does nothing where there is no folder for it.
void cachePythonKinds(const std::string& file, const std::string& json);

} // namespace trundle
