#pragma once
// How the author of a file writes.

#include <string>
#include <string_view>

#include "lang/tree.h"

namespace trundle {

struct EditStyle {
    std::string lineEnd = "\n";
    std::string step = "  ";  ///< one level of indent
    bool spacedEquals = true; ///< `Key = value` rather than `Key=value`
    std::size_t itemGap = 1;  ///< blanks between items of one line
};

[[nodiscard]] EditStyle editStyle(const Tree& tree);
/// As the assignments of the block do it; where it has none, as the file.
[[nodiscard]] bool spacedEquals(const Tree& tree, const BlockItem* block, const EditStyle& style);
/// The blanks at the beginning of the line that holds `offset`.
[[nodiscard]] std::string indentOfLine(std::string_view bytes, std::uint32_t offset);

} // namespace trundle
