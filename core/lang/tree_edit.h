#pragma once
// Edits of a tree as the smallest possible splice of its bytes, in the file's own style (indent, line ends, spacing of `=`).
// Each function gives the text edits that do it; applying them and parsing again gives the new tree. Undo keeps the old tree.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "base/text_edit.h"
#include "lang/tree.h"

namespace trundle {

/// The end of the last comment that stands behind an offset on its line, else the offset: nothing is put behind a `//`.
[[nodiscard]] std::uint32_t behindComments(const Tree& tree, std::uint32_t from);

/// Set the value of an assignment that exists: only the value's characters change.
[[nodiscard]] TextEdit editSetValue(const Tree& tree, const Value& value, std::string_view newText);
/// Replace a name (block name, word value, key).
[[nodiscard]] TextEdit editReplace(const Tree& tree, TextRange range, std::string_view newText);
/// Add `Key = text` as the last assignment of a block (nullptr: of the file), beside its like: on the block's one line if it is
/// written on one line, else on a line of its own with the indent of its neighbours.
[[nodiscard]] TextEdit editAddAssignment(const Tree& tree, const BlockItem* block, std::string_view key, std::string_view text);
/// Add the text of a whole item (a block, a directive) at the end of a block or of the file, re-indented to its place.
[[nodiscard]] TextEdit editAddItem(const Tree& tree, const BlockItem* block, std::string_view itemText);
/// Remove an item with the blanks and, when it stood alone, the line that held it; comments of other items stay.
[[nodiscard]] TextEdit editRemoveItem(const Tree& tree, const Item& item);

/// Applies edits to bytes; they must not overlap and may come in any order.
[[nodiscard]] Result<std::string> applyEdits(std::string_view bytes, std::span<const TextEdit> edits);
/// Applies and parses again: the new tree keeps path and FileId.
[[nodiscard]] Result<std::shared_ptr<const Tree>> applyEdits(const Tree& tree, std::span<const TextEdit> edits);

} // namespace trundle
