#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace trundle {

[[nodiscard]] constexpr bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
[[nodiscard]] constexpr bool isDigit(char c) { return c >= '0' && c <= '9'; }
[[nodiscard]] constexpr bool isIdentStart(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
[[nodiscard]] constexpr bool isIdent(char c) { return isIdentStart(c) || isDigit(c); }
[[nodiscard]] constexpr bool isWordChar(char c) { return isIdent(c) || c == '.' || c == '/' || c == '\\' || c == '-'; }

/// Whether a word begins like a kind or a property.
[[nodiscard]] constexpr bool isCapital(std::string_view word) { return !word.empty() && word[0] >= 'A' && word[0] <= 'Z'; }

/// Unusual space characters and zero-width characters, which come from pasted text.
[[nodiscard]] constexpr bool isInvisible(std::uint32_t point) {
    return point == 0xA0 || point == 0xAD || point == 0xFEFF || (point >= 0x2000 && point <= 0x200F) ||
           (point >= 0x2028 && point <= 0x202F) || point == 0x205F || point == 0x2060 || point == 0x3000;
}

/// An approximation of letters beyond ASCII: they are lexed as parts of a word, so that one diagnostic covers the whole word.
[[nodiscard]] constexpr bool isForeignLetter(std::uint32_t point) {
    return (point >= 0xC0 && point <= 0x24F && point != 0xD7 && point != 0xF7) || (point >= 0x370 && point <= 0x1FFF) ||
           (point >= 0x3040 && point <= 0xD7FF) || (point >= 0x20000 && point <= 0x2FFFF);
}

/// import, loadModule and common misspellings of them (any case, #include), without the `#`.
[[nodiscard]] bool isDirectiveLike(std::string_view name);

/// The unit that is meant by one without `^`: "m/s^2" for "m/s2"; empty if there is none.
[[nodiscard]] std::string unitWithPower(std::string_view written);

/// `${name}` as the lexer reads it.
[[nodiscard]] constexpr bool isBracedParam(std::string_view token) { return token.size() > 3 && token.starts_with("${"); }

/// End of a text in 'single' or typographic quotes that begins at `at` and is closed shortly after on the same line; `at` if
/// there is none.
[[nodiscard]] std::size_t foreignQuoteEnd(std::string_view text, std::size_t at);

} // namespace trundle
