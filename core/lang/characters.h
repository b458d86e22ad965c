#pragma once
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace trundle {

[[nodiscard]] constexpr bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
[[nodiscard]] constexpr bool isDigit(char c) { return c >= '0' && c <= '9'; }
[[nodiscard]] constexpr bool isIdentStart(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
[[nodiscard]] constexpr bool isIdent(char c) { return isIdentStart(c) || isDigit(c); }
[[nodiscard]] constexpr bool isWordChar(char c) { return isIdent(c) || c == '.' || c == '/' || c == '\\' || c == '-'; }

/// Blanks that a keyboard does not make, and signs that take no room: they come with pasted text.
[[nodiscard]] constexpr bool isInvisible(std::uint32_t point) {
    return point == 0xA0 || point == 0xAD || point == 0xFEFF || (point >= 0x2000 && point <= 0x200F) ||
           (point >= 0x2028 && point <= 0x202F) || point == 0x205F || point == 0x2060 || point == 0x3000;
}

/// Letters beyond ASCII, near enough: they are read as parts of a word so that one message names the whole word.
[[nodiscard]] constexpr bool isForeignLetter(std::uint32_t point) {
    return (point >= 0xC0 && point <= 0x24F && point != 0xD7 && point != 0xF7) || (point >= 0x370 && point <= 0x1FFF) ||
           (point >= 0x3040 && point <= 0xD7FF) || (point >= 0x20000 && point <= 0x2FFFF);
}

/// import, loadModule and what people write for them (any case, #include), without the `#`.
[[nodiscard]] bool isDirectiveLike(std::string_view name);

/// End of a text in 'quotes' or typographic quotes that begins at `at` and closes soon on the same line; `at` when there is none.
[[nodiscard]] std::size_t foreignQuoteEnd(std::string_view text, std::size_t at);

} // namespace trundle
