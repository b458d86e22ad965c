#pragma once
// Text of others (files, modules, other programs), made harmless for a terminal, a label or a dialog.

#include <cstdint>
#include <string>
#include <string_view>

namespace trundle {

/// Whether a code point is shown by no sign of its own and may change what others look like: control characters, line and paragraph
/// separators, and the marks that turn the direction of writing. Tab and line feed are such too.
[[nodiscard]] bool isControl(std::uint32_t codePoint);

/// Valid UTF-8 without control characters but tab and line feed; each other one, and each byte that is no UTF-8, becomes U+FFFD.
/// CR LF and a CR by itself become a line feed.
[[nodiscard]] std::string cleanText(std::string_view text);
/// The same in one line: a line break becomes a blank.
[[nodiscard]] std::string cleanLine(std::string_view text);

} // namespace trundle
