#pragma once
#include "base/source_range.h"

namespace trundle {

enum class TokenKind {
    // trivia
    Bom,
    Space,
    LineEnd,
    LineComment,
    BlockComment,
    // words and values
    Word,   ///< names, keys, kinds and word values (with . / \ - where the lexer sees a value)
    Number, ///< without its unit
    Unit,
    String,
    ParamRef, ///< $name
    ExprOpen, ///< $(
    // punctuation
    OpenBrace,
    CloseBrace,
    OpenParen,
    CloseParen,
    Equals,
    Comma,
    Dot,
    Plus,
    Minus,
    Star,
    Slash,
    Caret,
    Directive, ///< #import or #loadModule
    Path,      ///< the rest of a directive's line
    Unknown,   ///< what no rule reads; kept as found
    End,
};

/// Tokens of a file stand end to end: the first begins at 0, each begins where the last ended.
struct Token {
    TokenKind kind = TokenKind::Unknown;
    TextRange range;
};

[[nodiscard]] inline bool isTrivia(TokenKind kind) { return kind <= TokenKind::BlockComment; }

/// Whether a word, number, path or quoted text is longer than any that means something.
[[nodiscard]] inline bool isTooLong(const Token& token) {
    constexpr std::uint32_t kLongestWord = 4096, kLongestString = 65536; // bytes
    if (isTrivia(token.kind)) return false;
    return token.range.size() > (token.kind == TokenKind::String ? kLongestString : kLongestWord);
}

} // namespace trundle
