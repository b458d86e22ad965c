#pragma once
// What is said about the word under the mouse.

#include <optional>
#include <string>
#include <vector>

#include "project/project.h"

namespace trundle {

struct Hover {
    TextRange word;
    std::string title;              ///< "Radius", "Box"
    std::vector<std::string> lines; ///< plain texts
};

[[nodiscard]] std::optional<Hover> hoverAt(const Loaded& loaded, FileId file, std::uint32_t offset);
/// As rich text; the problems at the place come first.
[[nodiscard]] std::string hoverHtml(const std::optional<Hover>& hover, const std::vector<const Diagnostic*>& problems);

} // namespace trundle
