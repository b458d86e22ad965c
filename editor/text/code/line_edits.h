#pragma once
// Line commands of the text editor, as splices of the text. Positions are byte offsets; a selection is anchor and caret.

#include <optional>
#include <string>
#include <string_view>

#include "editor/text/code/splice.h"

namespace trundle {

struct LineEdit {
    Splice splice;
    std::size_t anchor = 0, caret = 0; ///< the selection after the edit
};

/// Adds `mark` to each line of the selection, or removes it if every line that is not empty has one.
[[nodiscard]] std::optional<LineEdit> toggleComment(std::string_view text, std::size_t anchor, std::size_t caret,
                                                    std::string_view mark = "//");
/// Copies the lines of the selection below themselves and selects the copy.
[[nodiscard]] std::optional<LineEdit> duplicateLines(std::string_view text, std::size_t anchor, std::size_t caret,
                                                     std::string_view lineEnd);
/// Moves the lines of the selection up (-1) or down (+1) by one line.
[[nodiscard]] std::optional<LineEdit> moveLines(std::string_view text, std::size_t anchor, std::size_t caret, int direction);
/// Replaces the selection by a line break: indented like the line above, one step more after `{`, or after a `:` at the end of the line
/// if that `colonOpens` a block; a `}` after the caret gets its own line.
[[nodiscard]] LineEdit newLine(std::string_view text, std::size_t anchor, std::size_t caret, std::string_view lineEnd,
                               std::string_view step, bool colonOpens = false);
/// Inserts a `}` at the caret if only blanks precede it, indented like the line of its `{`.
[[nodiscard]] std::optional<LineEdit> closeBrace(std::string_view text, std::size_t caret);

} // namespace trundle
