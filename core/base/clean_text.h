#pragma once
// Makes text from outside (files, modules, other programs) safe to show in a terminal, a label or a dialog.

#include <cstdint>
#include <string>
#include <string_view>

namespace trundle {

/// Whether a code point is invisible and may change how other text is displayed: control characters (including tab and line
/// feed), line and paragraph separators, and bidirectional formatting characters.
[[nodiscard]] bool isControl(std::uint32_t codePoint);

/// Valid UTF-8 without control characters except tab and line feed. Every other control character and every byte that is not
/// UTF-8 becomes U+FFFD. CR LF and a lone CR become a line feed.
[[nodiscard]] std::string cleanText(std::string_view text);
/// The same on one line: a line break becomes a space.
[[nodiscard]] std::string cleanLine(std::string_view text);

} // namespace trundle
