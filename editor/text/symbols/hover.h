#pragma once
// The tooltip of the word under the mouse pointer.

#include <optional>
#include <string>
#include <vector>

#include "project/loading/project.h"

namespace trundle {

struct Hover {
    TextRange word;
    std::string title;              ///< "Radius", "Box"
    std::vector<std::string> lines; ///< plain text
};

[[nodiscard]] std::optional<Hover> hoverAt(const LoadedProject& loaded, FileId file, std::uint32_t offset);
/// As rich text; diagnostics at the offset come first.
[[nodiscard]] std::string hoverHtml(const std::optional<Hover>& hover, const std::vector<const Diagnostic*>& problems);

} // namespace trundle
