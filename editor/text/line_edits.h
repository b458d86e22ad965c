#pragma once
// What the editor's commands do with whole lines, as splices of the text. Places are bytes; a selection is its anchor and caret.

#include <optional>
#include <string>
#include <string_view>

#include "editor/text/splice.h"

namespace trundle {

struct LineEdit {
    Splice splice;
    std::size_t anchor = 0, caret = 0; ///< of the selection afterwards
};

/// Puts `//` before each line of the selection, or takes it away where every line that is not empty has one.
[[nodiscard]] std::optional<LineEdit> toggleComment(std::string_view text, std::size_t anchor, std::size_t caret);
/// The lines of the selection once more below themselves; the copy is selected.
[[nodiscard]] std::optional<LineEdit> duplicateLines(std::string_view text, std::size_t anchor, std::size_t caret,
                                                     std::string_view lineEnd);
/// The lines of the selection change places with the line above (-1) or below (+1).
[[nodiscard]] std::optional<LineEdit> moveLines(std::string_view text, std::size_t anchor, std::size_t caret, int direction);
/// A new line at the caret in place of the selection: indented as the line above, deeper after `{`, a `}` behind the caret on a
/// line of its own.
[[nodiscard]] LineEdit newLine(std::string_view text, std::size_t anchor, std::size_t caret, std::string_view lineEnd,
                               std::string_view step);
/// A `}` typed at the caret, where only blanks stand before it: as deep as the line of its `{`.
[[nodiscard]] std::optional<LineEdit> closeBrace(std::string_view text, std::size_t caret);

} // namespace trundle
