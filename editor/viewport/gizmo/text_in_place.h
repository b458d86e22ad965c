#pragma once
#include <string>

namespace trundle {

struct LoadedProject;

/// The text of a property ("robot0.hull.Size") where an edit through this path would replace it; empty: it gets a new value.
[[nodiscard]] std::string textInPlace(const LoadedProject& loaded, const std::string& property);

} // namespace trundle
