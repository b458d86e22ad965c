#pragma once
// Edits of a tree as the smallest possible splice of its bytes, in the file's own style (indent, line ends, spaces around `=`).
// Each function returns text edits; applying them and parsing again gives the new tree. Undo keeps the old tree.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "base/text_edit.h"
#include "lang/tree.h"

namespace trundle {

/// The end of the last comment after an offset on its line, or the offset itself: text inserted after `//` would be lost.
[[nodiscard]] std::uint32_t behindComments(const Tree& tree, std::uint32_t from);

/// Replaces the value of an existing assignment; only the value's characters change.
[[nodiscard]] TextEdit editSetValue(const Tree& tree, const Value& value, std::string_view newText);
/// The same for the value with this range.
[[nodiscard]] TextEdit editSetValue(const Tree& tree, TextRange value, std::string_view newText);
/// Replaces a name (block name, word value, key).
[[nodiscard]] TextEdit editReplace(const Tree& tree, TextRange range, std::string_view newText);
/// Adds `Key = text` as the last assignment of a block (nullptr: of the file): on the same line if the block is written on one
/// line, before its blocks if it has no assignment, otherwise on a new line with the indent of its neighbours. The first one of a
/// file is put behind the directives and Params at its top, or before its first item.
[[nodiscard]] TextEdit editAddAssignment(const Tree& tree, const BlockItem* block, std::string_view key, std::string_view text);
/// Adds `Param name = text` after the last Param of a block, or as its first item.
[[nodiscard]] TextEdit editAddParam(const Tree& tree, const BlockItem& block, std::string_view name, std::string_view text);
/// Appends the text of a whole item (a block, a directive) to a block or file, re-indented for its new position.
[[nodiscard]] TextEdit editAddItem(const Tree& tree, const BlockItem* block, std::string_view itemText);
/// Removes an item with its surrounding spaces and, if it is alone on its line, the line; comments of other items are kept.
[[nodiscard]] TextEdit editRemoveItem(const Tree& tree, const Item& item);

/// Applies edits to bytes. They must not overlap; any order is allowed.
[[nodiscard]] Result<std::string> applyEdits(std::string_view bytes, std::span<const TextEdit> edits);
/// Applies the edits and parses again: the new tree keeps path and FileId.
[[nodiscard]] Result<std::shared_ptr<const Tree>> applyEdits(const Tree& tree, std::span<const TextEdit> edits);

} // namespace trundle
