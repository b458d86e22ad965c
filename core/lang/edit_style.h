#pragma once
// Detects the formatting style of a file, so that edits match it.

#include <string>
#include <string_view>

#include "lang/tree.h"

namespace trundle {

struct EditStyle {
    std::string lineEnd = "\n";
    std::string step = "  ";  ///< one level of indent
    bool spacedEquals = true; ///< `Key = value` rather than `Key=value`
};

[[nodiscard]] EditStyle editStyle(const Tree& tree);
/// The style of the block's assignments; the file's style if it has none.
[[nodiscard]] bool spacedEquals(const Tree& tree, const BlockItem* block, const EditStyle& style);
/// The spaces and tabs at the start of the line that contains `offset`.
[[nodiscard]] std::string indentOfLine(std::string_view bytes, std::uint32_t offset);

} // namespace trundle
